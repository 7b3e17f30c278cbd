// Nodes that a stage changed: members that differ are written, and nothing else.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"

namespace foredraw::patch_nodes_test {
namespace {

using namespace foredraw::testing;

/// Node 0 draws a morphed ribbon, 1 holds 2, which has a matrix; all with something that no scene knows.
GltfBuilder cart() {
  GltfBuilder made = ribbon(4);
  GltfJson& primitive = made.json["meshes"][0]["primitives"][0];
  for (const float by : {0.5f, 1.0f}) {
    const std::size_t target = made.add_values(std::vector<float>(30, by), "VEC3");
    for (const char* end : {"min", "max"}) made.json["accessors"][target][end] = {by, by, by};
    primitive["targets"].push_back({{"POSITION", target}});
  }
  made.json["nodes"][0] = GltfJson::parse(
      R"({"extras":{"z":1},"mesh":0,"translation":[0.1,0.2,0.3],"weights":[0.25,1e-1],"rotation":[0,0,0.6,0.8]})");
  made.add("nodes", GltfJson::parse(R"({"name":"axle","scale":[2,2,2.0],"children":[2],"extras":"kept"})"));
  made.add("nodes", GltfJson::parse(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,4,5,6,1],"camera":0})"));
  made.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
  made.add("scenes", {{"nodes", {0, 1}}});
  made.json["scene"] = 0;
  return made;
}

/// How the writer refuses: the place, and the beginning of the message.
std::string refusal(const Scene& scene) {
  Diagnostics diagnostics;
  if (encode_gltf(scene, "out.glb", diagnostics)) return "written";
  const Diagnostic& said = diagnostics.all().at(0);
  return said.where.inside + ": " + said.message.substr(0, said.message.find(';'));
}

void expect_same_nodes(const Scene& is, const Scene& want) {
  ASSERT_EQ(is.nodes.size(), want.nodes.size());
  for (std::size_t i = 0; i < is.nodes.size(); ++i) {
    const Node &a = is.nodes[i], &b = want.nodes[i];
    EXPECT_EQ(a.name, b.name) << i;
    EXPECT_TRUE(a.transform.translation == b.transform.translation) << i;
    EXPECT_TRUE(a.transform.rotation == b.transform.rotation) << i;
    EXPECT_TRUE(a.transform.scale == b.transform.scale) << i;
    EXPECT_TRUE(a.matrix == b.matrix) << i;
    EXPECT_EQ(a.mesh, b.mesh) << i;
    EXPECT_EQ(a.skin, b.skin) << i;
    EXPECT_EQ(a.weights, b.weights) << i;
    EXPECT_EQ(a.children, b.children) << i;
    EXPECT_EQ(a.is_shown, b.is_shown) << i;
    EXPECT_EQ(a.instances, b.instances) << i;
  }
}

TEST(GltfPatchNodes, write_the_members_that_differ_and_nothing_else) {
  Scene scene = read(cart());
  scene.nodes[0].transform.translation = {0.5f, 0.25f, 8};
  scene.nodes[1].transform.rotation = glm::quat(0, 1, 0, 0);
  GltfJson want = json_of(cart().glb());
  want["nodes"][0]["translation"] = {0.5, 0.25, 8.0};
  want["nodes"][1]["rotation"] = {1.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(written(scene).dump(), want.dump()) << "every other letter stays";
  expect_same_nodes(read(write(scene)), scene);

  scene.nodes[0].transform.translation = glm::vec3(0);
  scene.nodes[0].transform.rotation = glm::quat(1, 0, 0, 0);
  scene.nodes[0].weights = {1, 0.5f};
  scene.nodes[1].transform = {};
  scene.nodes[1].name = "wheel";
  const GltfJson json = written(scene);
  EXPECT_EQ(json["nodes"][0].dump(), R"({"extras":{"z":1},"mesh":0,"weights":[1.0,0.5]})") << "what holds anyway";
  EXPECT_EQ(json["nodes"][1].dump(), R"({"name":"wheel","children":[2],"extras":"kept"})");
  EXPECT_EQ(json["nodes"][2].dump(), cart().json["nodes"][2].dump());
  expect_same_nodes(read(write(scene)), scene);
}

TEST(GltfPatchNodes, what_was_changed_and_changed_back_is_the_same_file) {
  const Scene was = read(cart());
  Scene scene = was;
  scene.nodes[0].transform.scale.y = 3;
  EXPECT_NE(write(scene), cart().glb());
  scene.nodes = was.nodes;
  EXPECT_EQ(write(scene), cart().glb());
}

TEST(GltfPatchNodes, a_matrix_stays_one) {
  Scene scene = read(cart());
  scene.nodes[2].matrix = glm::mat4(1);
  GltfJson json = written(scene);
  EXPECT_EQ(json["nodes"][2].dump(),
            R"({"matrix":[1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0],"camera":0})");
  expect_same_nodes(read(write(scene)), scene);
}

TEST(GltfPatchNodes, numbers_are_read_back_to_the_last_bit) {
  std::mt19937 random(7);
  std::vector<float> values{0.1f, 1.0f / 3, 16777217.0f, 1e-45f, 1.1754944e-38f, 3.4028235e38f, -3.4028235e38f, -1e-6f};
  while (values.size() < 600) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) values.push_back(value);
  }
  Scene scene = read(cart());
  for (std::size_t i = 0; i + 6 < values.size(); i += 6) {
    scene.nodes[0].transform.translation = {values[i], values[i + 1], values[i + 2]};
    scene.nodes[0].transform.scale = {values[i + 3], values[i + 4], values[i + 5]};
    scene.nodes[0].weights = {values[i + 1], values[i + 3]};
    for (int c = 0; c < 12; ++c)
      (*scene.nodes[2].matrix)[c / 3][c % 3] = values[(i + static_cast<std::size_t>(c)) % values.size()];
    const Scene again = read(write(scene));
    expect_same_nodes(again, scene);
    ASSERT_FALSE(::testing::Test::HasFailure()) << i;
  }
}

TEST(GltfPatchNodes, what_glTF_has_no_words_for_is_refused) {
  const Scene scene = read(cart());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const auto with = [&](auto change) {
    Scene changed = scene;
    change(changed);
    return refusal(changed);
  };
  EXPECT_EQ(with([&](Scene& s) { s.nodes[0].transform.translation.x = nan; }), "nodes[0]: its transform is not finite");
  EXPECT_EQ(with([&](Scene& s) { s.nodes[1].transform.rotation.w = infinite; }),
            "nodes[1]: its transform is not finite");
  EXPECT_EQ(with([&](Scene& s) { s.nodes[0].weights[1] = nan; }), "nodes[0]: its morph weights are not finite");
  const std::string matrix = "nodes[2]: its matrix is not finite, or its last row is not 0, 0, 0, 1";
  EXPECT_EQ(with([&](Scene& s) { (*s.nodes[2].matrix)[3][1] = -infinite; }), matrix);
  EXPECT_EQ(with([&](Scene& s) { (*s.nodes[2].matrix)[0][3] = 1; }), matrix);
  EXPECT_EQ(with([&](Scene& s) { (*s.nodes[2].matrix)[3][3] = 2; }), matrix);
  EXPECT_EQ(with([&](Scene& s) { s.nodes.emplace_back().transform.scale.z = nan; }),
            "nodes[3]: its transform is not finite");
}

TEST(GltfPatchNodes, other_changes_are_refused) {
  const Scene scene = read(cart());
  const auto with = [&](auto change) {
    Scene changed = scene;
    change(changed);
    return refusal(changed);
  };
  const std::string kind = ": its matrix was replaced by translation, rotation and scale, or these by a matrix";
  EXPECT_EQ(with([](Scene& s) { s.nodes[2].matrix.reset(); }), "nodes[2]" + kind);
  EXPECT_EQ(with([](Scene& s) { s.nodes[2].transform.scale.x = 2; }), "nodes[2]" + kind);
  EXPECT_EQ(with([](Scene& s) { s.nodes[0].matrix = glm::mat4(1); }), "nodes[0]" + kind);
  EXPECT_EQ(with([](Scene& s) { s.nodes[1].mesh = 0; }), "nodes[1]: it was given another mesh");
  EXPECT_EQ(with([](Scene& s) { s.nodes[1].skin = 0; }), "nodes[1]: its skin was changed");
  EXPECT_EQ(with([](Scene& s) { s.nodes[0].mesh.reset(); }),
            "nodes[0]: its mesh was removed, but not its morph weights");
  EXPECT_EQ(with([](Scene& s) { s.nodes[0].instances = Shared<Transform>(std::vector<Transform>(2)); }),
            "nodes[0]: its number of instances was changed");
  EXPECT_EQ(with([](Scene& s) { s.nodes.pop_back(); }), "nodes: some were removed");
  const std::string children = ": children that the file has were added to it or taken from it";
  EXPECT_EQ(with([](Scene& s) { s.nodes[1].children.clear(); }), "nodes[1]" + children);
  EXPECT_EQ(with([](Scene& s) { s.nodes[1].children = {2, 0}; }), "nodes[1]" + children);
  EXPECT_EQ(with([](Scene& s) { s.roots = {0}; }), "the scene's roots: some were added or removed");
}

TEST(GltfPatchNodes, children_hang_below_one_node_that_is_there) {
  const std::string why = ": one of its children is not there, or is a child elsewhere, too";
  Scene scene = read(cart());
  scene.nodes[1].children = {2, 3};
  EXPECT_EQ(refusal(scene), "nodes[1]" + why);
  scene.nodes.emplace_back();
  EXPECT_EQ(refusal(scene), "written");
  scene.nodes[0].children = {3};
  EXPECT_EQ(refusal(scene), "nodes[1]" + why);
  scene.nodes[0].children.clear();
  scene.nodes[1].children = {3, 2, 3};
  EXPECT_EQ(refusal(scene), "nodes[1]" + why);
}

/// Node 0 as it is placed, and a new child that draws its mesh at a place of its own.
Scene with_child(Scene scene) {
  Node child;
  child.mesh = scene.nodes[0].mesh;
  child.weights = scene.nodes[0].weights;
  child.transform = {{0, 0.5f, 0}, {1, 0, 0, 0}, glm::vec3(0.125f)};
  scene.nodes[0].children.push_back(static_cast<NodeId>(scene.nodes.size()));
  scene.nodes[0].mesh.reset();
  scene.nodes[0].weights.clear();
  scene.nodes.push_back(child);
  return scene;
}

TEST(GltfPatchNodes, a_mesh_goes_to_a_new_child_and_its_weights_with_it) {
  GltfBuilder builder = cart();
  const Scene scene = with_child(read(builder));
  const GltfJson json = written(scene);
  EXPECT_EQ(json["nodes"][0].dump(),
            R"({"extras":{"z":1},"translation":[0.1,0.2,0.3],"rotation":[0,0,0.6,0.8],"children":[3]})");
  EXPECT_EQ(json["nodes"][3]["weights"].get<std::vector<float>>(), (std::vector<float>{0.25f, 0.1f}));
  EXPECT_EQ(json["scenes"], builder.json["scenes"]) << "a child is no root";
  expect_same_nodes(read(write(scene)), scene);

  builder.json["nodes"][0].erase("weights");
  builder.json["nodes"][0]["children"] = {3};
  builder.add("nodes", {{"name", "lantern"}});
  const Scene second = with_child(read(builder));
  EXPECT_EQ(written(second)["nodes"][0]["children"], GltfJson::array({3, 4}));
  expect_same_nodes(read(write(second)), second);
}

TEST(GltfPatchNodes, of_a_further_scene_may_be_placed_anew_but_keep_their_mesh) {
  GltfBuilder builder = cart();
  builder.add("scenes", {{"nodes", {0}}, {"name", "close-up"}});
  Scene scene = read(builder);
  scene.nodes[0].transform.scale = glm::vec3(0.5f);
  const GltfJson json = written(scene);
  EXPECT_EQ(json["scenes"], builder.json["scenes"]);
  EXPECT_EQ(json["nodes"][0]["scale"], GltfJson::array({0.5, 0.5, 0.5}));
  expect_same_nodes(read(write(scene)), scene);
  EXPECT_EQ(refusal(with_child(scene)),
            "nodes[0]: its mesh was removed, but an extension or a further scene refers to "
            "it, or no scene shows it");
}

/// `cart` with weights and place of node 0 animated, and something that no scene knows wherever there is room.
GltfBuilder moving_cart() {
  GltfBuilder made = cart();
  const std::size_t times = made.add_values(std::vector<float>{0, 1}, "SCALAR");
  made.json["accessors"][times]["min"] = {0};
  made.json["accessors"][times]["max"] = {1};
  const std::size_t places = made.add_values(std::vector<float>{0, 0, 0, 1, 2, 3}, "VEC3");
  const std::size_t weights = made.add_values(std::vector<float>{0, 1, 1, 0}, "SCALAR");
  made.add(
      "animations",
      {{"samplers", {{{"input", times}, {"output", places}}, {{"input", times}, {"output", weights}, {"extras", 5}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
         {{"sampler", 1}, {"target", {{"path", "weights"}, {"node", 0}, {"extras", 6}}}, {"extras", 7}}}}});
  return made;
}

TEST(GltfPatchNodes, animated_weights_move_the_child_that_draws_the_mesh) {
  const GltfBuilder builder = moving_cart();
  Scene scene = with_child(read(builder));
  EXPECT_EQ(refusal(scene),
            "animations[0]: it moves the morph weights of node 0, whose mesh is gone or has another number of morph "
            "targets");
  scene.animations[0].channels[1].node = 3;
  GltfJson want = builder.json["animations"];
  want[0]["channels"][1]["target"]["node"] = 3;
  EXPECT_EQ(written(scene)["animations"].dump(), want.dump());
  EXPECT_EQ(written(scene)["accessors"], json_of(builder.glb())["accessors"]) << "keys stay where they are";
  Scene again = read(write(scene));
  expect_same_nodes(again, scene);
  EXPECT_EQ(again.animations[0].channels[1].node, 3u);
  EXPECT_EQ(again.animations[0].channels[1].values, scene.animations[0].channels[1].values);

  scene.animations[0].channels[1].values = Shared<float>(std::vector<float>{0, 0.5f, 1, 0.5f});
  again = read(write(scene));
  EXPECT_EQ(again.animations[0].channels[1].node, 3u);
  EXPECT_EQ(again.animations[0].channels[1].values, scene.animations[0].channels[1].values);
  EXPECT_EQ(written(scene)["animations"][0]["channels"][1]["target"]["extras"], 6);
  EXPECT_FALSE(written(scene)["accessors"][7].contains("bufferView")) << "nobody names the old keys";

  scene.animations[0].channels.erase(scene.animations[0].channels.begin());
  again = read(write(scene));
  ASSERT_EQ(again.animations[0].channels.size(), 1u);
  EXPECT_EQ(again.animations[0].channels[0].node, 3u);
}

TEST(GltfPatchNodes, channels_that_move_something_else_are_refused) {
  const Scene scene = with_child(read(moving_cart()));
  const std::string moved = "animations[0]: channels were added or moved, or all are gone";
  Scene changed = scene;
  changed.animations[0].channels[0].node = 3;
  EXPECT_EQ(refusal(changed), moved) << "its place is not that of the node";
  changed = scene;
  changed.animations[0].channels[1].node = 1;
  EXPECT_EQ(refusal(changed), moved) << "a node that the file has";
  changed = scene;
  changed.nodes.push_back(changed.nodes[3]);
  changed.animations[0].channels[1].node = 4;
  EXPECT_EQ(refusal(changed), moved) << "no child of the node";
  changed = scene;
  changed.animations[0].channels[1].node = 3;
  changed.nodes[3].mesh.reset();
  const std::string unfit =
      "animations[0]: it moves the morph weights of node 3, whose mesh is gone or has another number of morph targets";
  EXPECT_EQ(refusal(changed), unfit);
  changed.nodes[3].mesh = 77;
  EXPECT_EQ(refusal(changed), unfit);
  changed.nodes[3].mesh = 0;
  changed.animations[0].channels[1].values = Shared<float>(std::vector<float>{0, 1});
  EXPECT_EQ(refusal(changed), unfit) << "one weight for two targets";
}

/// Two nodes whose weights move, the first of which gave its mesh to a child; then the second did, too.
TEST(GltfPatchNodes, channels_of_weights_are_told_apart) {
  GltfBuilder builder = moving_cart();
  builder.add("nodes", {{"mesh", 0}});
  builder.json["scenes"][0]["nodes"] = {0, 1, 3};
  GltfJson& animation = builder.json["animations"][0];
  animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 3}, {"path", "weights"}}}, {"extras", "3"}});
  Scene scene = with_child(read(builder));
  scene.animations[0].channels[1].node = 4;
  GltfJson json = written(scene);
  EXPECT_EQ(json["animations"][0]["channels"][1]["target"]["node"], 4);
  EXPECT_EQ(json["animations"][0]["channels"][2], animation["channels"][2]);

  Scene other = read(builder);  // the second alone, and the channel of the first is gone
  other.nodes.push_back(other.nodes[3]);
  other.nodes[3].mesh.reset();
  other.nodes[3].children = {4};
  other.animations[0].channels.erase(other.animations[0].channels.begin() + 1);
  other.animations[0].channels[1].node = 4;
  json = written(other);
  ASSERT_EQ(json["animations"][0]["channels"].size(), 2u);
  EXPECT_EQ(json["animations"][0]["channels"][1]["extras"], "3");
  EXPECT_EQ(read(write(other)).animations[0].channels[1].node, 4u);
}

}  // namespace
}  // namespace foredraw::patch_nodes_test
