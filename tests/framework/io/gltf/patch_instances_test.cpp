// EXT_mesh_gpu_instancing of nodes that a stage changed: attributes that differ become floats, and the others stay.
#include <gtest/gtest.h>

#include <limits>

#include "framework/io/gltf/compressed_scenes.h"

namespace foredraw::patch_instances_test {
namespace {

using namespace foredraw::testing;

constexpr const char* instancing = "EXT_mesh_gpu_instancing";

/// Three instances of a ribbon: places, turns of 16 bits, numbers and colours; and a second node that names the same.
struct Orchard {
  GltfBuilder builder = ribbon(2);
  std::size_t places, turns, numbers, colours;

  Orchard() {
    places = builder.add_values(std::vector<float>{0, 0, 0, 1, 2, 3, 4, 5, 6}, "VEC3");
    turns = builder.add_values(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 32767, 0, 0, 23170, 0, 0, 23170}, "VEC4");
    builder.json["accessors"][turns]["normalized"] = true;
    numbers = builder.add_values(std::vector<std::uint16_t>{7, 8, 9, 0}, "SCALAR");
    builder.json["accessors"][numbers]["count"] = 3;
    colours = builder.add_values(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
    const GltfJson extension{
        {"attributes", {{"_ID", numbers}, {"TRANSLATION", places}, {"ROTATION", turns}, {"_COLOR_0", colours}}},
        {"extras", {{"kind", "plum"}}}};
    builder.json["nodes"][0]["extensions"] = {{"KHR_xmp_json_ld", {{"packet", 0}}}, {instancing, extension}};
    builder.add("nodes", {{"mesh", 0}, {"translation", {9, 0, 0}}, {"extensions", {{instancing, extension}}}});
    builder.json["extensionsUsed"] = {"KHR_xmp_json_ld", instancing};
    builder.json["extensions"]["KHR_xmp_json_ld"]["packets"] = GltfJson::array({GltfJson::object()});
    builder.add("scenes", {{"nodes", {0, 1}}});
    builder.json["scene"] = 0;
  }

  std::vector<Transform> instances() const {
    const Shared<Transform> shared = read(builder).nodes[0].instances;
    return {shared.view().begin(), shared.view().end()};
  }
};

const GltfJson& attributes(const GltfJson& json, std::size_t node) {
  return json["nodes"][node]["extensions"][instancing]["attributes"];
}

bool has_bytes(const GltfJson& json, std::size_t accessor) {
  return json["accessors"][accessor].contains("bufferView");
}

void expect_same_instances(const Scene& is, const Scene& want) {
  ASSERT_EQ(is.nodes.size(), want.nodes.size());
  for (std::size_t i = 0; i < is.nodes.size(); ++i) EXPECT_EQ(is.nodes[i].instances, want.nodes[i].instances) << i;
}

TEST(GltfPatchInstances, the_attribute_that_differs_becomes_a_new_one_and_the_rest_stays) {
  const Orchard orchard;
  Scene scene = read(orchard.builder);
  std::vector<Transform> moved = orchard.instances();
  moved[2].translation = {0.1f, 1.0f / 3, -1e-30f};
  for (Node& node : scene.nodes) node.instances = Shared<Transform>(moved);

  const GltfJson json = written(scene);
  const std::size_t added = orchard.builder.json["accessors"].size();
  EXPECT_EQ(json["accessors"].size(), added + 1) << "who shared it goes on sharing it";
  EXPECT_EQ(json["accessors"][added]["componentType"], 5126);
  EXPECT_FALSE(has_bytes(json, orchard.places)) << "nobody names the old one";
  GltfJson want = orchard.builder.json["nodes"];
  for (GltfJson& node : want) node["extensions"][instancing]["attributes"]["TRANSLATION"] = added;
  EXPECT_EQ(json["nodes"].dump(), want.dump());
  EXPECT_EQ(json["accessors"][orchard.turns]["componentType"], 5122);
  EXPECT_EQ(json["accessors"][orchard.turns]["normalized"], true);

  const Scene again = read(write(scene));
  expect_same_instances(again, scene);
  EXPECT_TRUE(again.nodes[0].instances.is(again.nodes[1].instances));
  EXPECT_EQ(write(again), write(scene));
}

TEST(GltfPatchInstances, turns_of_16_bits_become_floats_where_one_differs) {
  const Orchard orchard;
  Scene scene = read(orchard.builder);
  std::vector<Transform> turned = orchard.instances();
  turned[0].rotation = glm::quat(0.6f, 0, 0.8f, 0);
  scene.nodes[0].instances = Shared<Transform>(turned);
  const GltfJson json = written(scene);
  EXPECT_EQ(json["accessors"][attributes(json, 0)["ROTATION"].get<std::size_t>()]["componentType"], 5126);
  EXPECT_EQ(attributes(json, 1), attributes(orchard.builder.json, 1));
  EXPECT_TRUE(has_bytes(json, orchard.turns)) << "the other node names them";
  expect_same_instances(read(write(scene)), scene);
}

TEST(GltfPatchInstances, an_attribute_that_was_not_there_is_added_where_an_instance_needs_it) {
  const Orchard orchard;
  Scene scene = read(orchard.builder);
  std::vector<Transform> grown = orchard.instances();
  grown[1].scale = glm::vec3(0.5f);
  scene.nodes[0].instances = Shared<Transform>(grown);
  GltfJson want = attributes(orchard.builder.json, 0);
  want["SCALE"] = orchard.builder.json["accessors"].size();
  EXPECT_EQ(attributes(written(scene), 0).dump(), want.dump());
  expect_same_instances(read(write(scene)), scene);

  GltfBuilder numbered = orchard.builder;  // nothing but numbers: all stand where the node does
  for (GltfJson& node : numbered.json["nodes"])
    node["extensions"][instancing]["attributes"] = {{"_ID", orchard.numbers}};
  scene = read(numbered);
  std::vector<Transform> placed(3);
  placed[2].translation.x = 4;
  scene.nodes[1].instances = Shared<Transform>(placed);
  EXPECT_EQ(attributes(written(scene), 1).size(), 2u);
  EXPECT_EQ(attributes(written(scene), 0).size(), 1u);
  expect_same_instances(read(write(scene)), scene);
}

/// One that the other node, an attribute of another name, or an extension that nobody knows may name.
TEST(GltfPatchInstances, an_accessor_that_somebody_names_keeps_its_bytes) {
  for (const std::string who : {"the other node", "another attribute", "an unknown extension", "nobody"}) {
    Orchard orchard;
    GltfJson& json = orchard.builder.json;
    if (who == "another attribute")
      json["nodes"][1]["extensions"][instancing]["attributes"]["_BEFORE"] = orchard.places;
    if (who == "an unknown extension") {
      json["nodes"][1]["extensions"]["ACME_orchard"] = {{"places", orchard.places}};
      json["extensionsUsed"].push_back("ACME_orchard");
    }
    Scene scene = read(orchard.builder);
    std::vector<Transform> moved = orchard.instances();
    moved[0].translation.y = 0.7f;
    for (Node& node : scene.nodes) node.instances = Shared<Transform>(moved);
    if (who == "the other node") scene.nodes[1].instances = Shared<Transform>(orchard.instances());
    EXPECT_EQ(has_bytes(written(scene), orchard.places), who != "nobody") << who;
    expect_same_instances(read(write(scene)), scene);
  }
}

/// The numbers in the extension of a compressed view are no accessors: the old one goes, whatever they are.
TEST(GltfPatchInstances, compressed_files_are_written_and_read_again) {
  const Orchard orchard;
  Scene plain = read(orchard.builder);
  for (const Compression first : {Compression::none, Compression::ext, Compression::khr}) {
    const Scene scene = first == Compression::none ? plain : read(encode(plain, first).files.front().bytes);
    for (const Compression second : {Compression::keep, Compression::none, Compression::ext, Compression::khr}) {
      Scene changed = scene;
      std::vector<Transform> moved = orchard.instances();
      for (Transform& t : moved) t.translation *= 0.3f, t.scale = glm::vec3(0.01f);
      for (Node& node : changed.nodes) node.instances = Shared<Transform>(moved);
      const Written made = encode(changed, second);
      const Scene again = read(made.files.front().bytes);
      expect_same_instances(again, changed);
      expect_same(again, changed);
      std::size_t named = 0, held = 0;
      for (const GltfJson& accessor : made.json["accessors"]) held += accessor.contains("bufferView");
      named = 3 + attributes(made.json, 0).size();  // positions, uvs and indices beside
      EXPECT_EQ(held, named) << static_cast<int>(first) << ' ' << static_cast<int>(second);
    }
  }
}

TEST(GltfPatchInstances, other_numbers_of_them_and_what_is_not_finite_are_refused) {
  const Orchard orchard;
  const auto refused = [&](const std::vector<Transform>& instances) {
    Scene scene = read(orchard.builder);
    scene.nodes[1].instances = Shared<Transform>(instances);
    Diagnostics diagnostics;
    const bool is_written = encode_gltf(scene, "out.glb", diagnostics).has_value();
    return is_written ? "written" : diagnostics.all().at(0).where.inside + ": " + diagnostics.all()[0].message;
  };
  std::vector<Transform> instances = orchard.instances();
  EXPECT_EQ(refused(instances), "written");
  instances[1].rotation.x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refused(instances), "nodes[1]: its instances are not finite; this cannot be written back");
  instances.resize(1);
  EXPECT_EQ(refused(instances), "nodes[1]: its number of instances was changed; this cannot be written back");
  EXPECT_EQ(refused({}), "nodes[1]: its number of instances was changed; this cannot be written back");
}

}  // namespace
}  // namespace foredraw::patch_instances_test
