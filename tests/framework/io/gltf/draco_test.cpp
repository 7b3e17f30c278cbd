// Files compressed by Draco are read as libdraco alone decodes them, and written plain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "framework/io/gltf/compressed_scenes.h"
#include "support/draco_gltf.h"

namespace foredraw::draco_test {
namespace {

using testing::draco_compressed;
using testing::DracoChoice;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::indices_of;
using testing::puppet;
using testing::ribbon;
using testing::stream;

constexpr const char* extension = "KHR_draco_mesh_compression";

GltfJson& primitive(GltfBuilder& builder) { return builder.json["meshes"][0]["primitives"][0]; }

/// A ribbon with every kind of attribute and component that glTF has for one.
GltfBuilder many_attributes() {
  GltfBuilder made = ribbon(30);
  const std::size_t vertices = 62;
  const auto add = [&](const char* semantic, std::size_t accessor) {
    primitive(made)["attributes"][semantic] = accessor;
  };
  std::vector<float> normals, tangents;
  std::vector<std::uint8_t> colours, joints;
  std::vector<std::uint16_t> uvs, weights;
  std::vector<std::int8_t> small;
  std::vector<std::int16_t> large;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const float angle = 0.1f * static_cast<float>(i);
    normals.insert(normals.end(), {std::cos(angle), std::sin(angle), 0});
    tangents.insert(tangents.end(), {-std::sin(angle), std::cos(angle), 0, i % 2 == 0 ? 1.0f : -1.0f});
    for (std::uint32_t c = 0; c < 3; ++c) colours.push_back(static_cast<std::uint8_t>(7 * i + c));
    for (std::uint32_t c = 0; c < 4; ++c) joints.push_back(static_cast<std::uint8_t>((i + c) % 9));
    for (std::uint32_t c = 0; c < 4; ++c) weights.push_back(static_cast<std::uint16_t>(1000 * (i + c)));
    for (std::uint32_t c = 0; c < 2; ++c) uvs.push_back(static_cast<std::uint16_t>(900 * i + c));
    for (std::uint32_t c = 0; c < 2; ++c) small.push_back(static_cast<std::int8_t>(4 * i - 120 + c));
    large.push_back(static_cast<std::int16_t>(1000 * static_cast<int>(i) - 31000));
    ids.push_back(100000 * i);
  }
  add("NORMAL", made.add_values(normals, "VEC3"));
  add("TANGENT", made.add_values(tangents, "VEC4"));
  add("COLOR_0", made.add_values(colours, "VEC3"));
  add("JOINTS_0", made.add_values(joints, "VEC4"));
  add("WEIGHTS_0", made.add_values(weights, "VEC4"));
  add("TEXCOORD_1", made.add_values(uvs, "VEC2"));
  add("_SMALL", made.add_values(small, "VEC2"));
  add("_LARGE", made.add_values(large, "SCALAR"));
  add("_ID", made.add_values(ids, "SCALAR"));
  for (const char* semantic : {"COLOR_0", "WEIGHTS_0", "TEXCOORD_1", "_SMALL"}) {
    made.json["accessors"][primitive(made)["attributes"][semantic].get<std::size_t>()]["normalized"] = true;
  }
  return made;
}

struct How {
  const char* name;
  DracoChoice choice;
};

void PrintTo(const How& how, std::ostream* out) { *out << how.name; }

class Draco : public ::testing::TestWithParam<How> {};

TEST_P(Draco, is_read_as_libdraco_decodes_it) {
  const GltfBuilder coded = draco_compressed(many_attributes(), GetParam().choice);
  const GltfJson& told = coded.json["meshes"][0]["primitives"][0]["extensions"][extension];
  const auto want = testing::decoded_by_draco(testing::view_bytes(coded, told["bufferView"]));
  ASSERT_EQ(want.indices.size(), 180u);
  Diagnostics diagnostics;
  const auto scene = read_gltf(coded.glb(), "test", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(indices_of(*scene, 0), want.indices);
  EXPECT_EQ(told["attributes"].size(), 11u);
  for (const auto& [semantic, id] : told["attributes"].items()) {
    const VertexStream& is = stream(*scene, 0, semantic.c_str());
    if (semantic == "TANGENT" || semantic == "NORMAL") continue;  // of length 1 again: below
    EXPECT_TRUE(std::ranges::equal(is.bytes.view(), want.attributes.at(id))) << semantic;
  }
  for (const char* semantic : {"NORMAL", "TANGENT"}) {
    const VertexStream& is = stream(*scene, 0, semantic);
    const auto& bytes = want.attributes.at(told["attributes"][semantic]);
    for (std::uint32_t v = 0; v < 62; ++v) {
      float was[3], squared = 0;
      std::memcpy(was, bytes.data() + v * is.format.bytes, sizeof was);
      for (const float part : was) squared += part * part;
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(decode_component(is, v, c), was[c] / std::sqrt(squared), 1e-5);
    }
  }
  EXPECT_TRUE(stream(*scene, 0, "COLOR_0").format.normalized);
  EXPECT_FALSE(stream(*scene, 0, "JOINTS_0").format.normalized);
}

INSTANTIATE_TEST_SUITE_P(Ways, Draco,
                         ::testing::Values(How{"sequential", {.sequential = true}},
                                           How{"sequential_quantized", {.sequential = true, .bits = 12}},
                                           How{"edgebreaker", {}}, How{"edgebreaker_quantized", {.bits = 10}},
                                           How{"edgebreaker_smallest", {.bits = 14, .speed = 0}},
                                           How{"edgebreaker_fastest", {.bits = 14, .speed = 10}},
                                           How{"beside_a_plain_copy", {.bits = 14, .plain_copy = true}}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(GltfDraco, what_rounding_put_out_of_bounds_is_put_back) {
  GltfBuilder plain = ribbon(30);
  std::vector<float> colours, tangents, weights;
  std::vector<std::uint8_t> joints(std::size_t{62} * 4, 0);
  for (int i = 0; i < 62; ++i) {
    const float part = 0.013f * static_cast<float>(i);
    colours.insert(colours.end(), {0, part, 1});
    tangents.insert(tangents.end(), {std::sin(part), std::cos(part), 0, 1});
    weights.insert(weights.end(), {part, 1 - part, 0, 0});
  }
  const auto add = [&](const char* semantic, std::size_t accessor) {
    primitive(plain)["attributes"][semantic] = accessor;
  };
  add("COLOR_0", plain.add_values(colours, "VEC3"));
  add("TANGENT", plain.add_values(tangents, "VEC4"));
  add("WEIGHTS_0", plain.add_values(weights, "VEC4"));
  add("JOINTS_0", plain.add_values(joints, "VEC4"));
  const Scene scene = testing::read(draco_compressed(plain, {.bits = 8}));
  for (std::uint32_t v = 0; v < 62; ++v) {
    double squared = 0, sum = 0;
    for (int c = 0; c < 3; ++c) {
      squared += std::pow(decode_component(stream(scene, 0, "TANGENT"), v, c), 2);
      const double colour = decode_component(stream(scene, 0, "COLOR_0"), v, c);
      EXPECT_TRUE(colour >= 0 && colour <= 1) << colour;
    }
    for (int c = 0; c < 4; ++c) sum += decode_component(stream(scene, 0, "WEIGHTS_0"), v, c);
    EXPECT_NEAR(squared, 1, 3e-5);
    EXPECT_NEAR(sum, 1, 2e-5);
  }
}

TEST(GltfDraco, what_was_encoded_without_loss_comes_out_again_with_skins_and_morph_targets) {
  const Scene want = testing::read(puppet());
  const Scene is = testing::read(draco_compressed(puppet(), {.sequential = true}));
  testing::expect_same(is, want, true);
  EXPECT_EQ(is.skins.size(), want.skins.size());
  EXPECT_EQ(is.draws[0].levels[0].vertices->morph_targets.size(), 1u);
}

TEST(GltfDraco, threads_change_nothing) {
  GltfBuilder many = ribbon(20);
  for (int i = 0; i < 9; ++i) many.json["meshes"][0]["primitives"].push_back(primitive(many));
  const auto file = draco_compressed(many, {.bits = 11}).glb();
  Diagnostics diagnostics;
  const auto one = read_gltf(file, "test", {}, diagnostics, {.executor = Executor(1)});
  const auto two = read_gltf(file, "test", {}, diagnostics, {.executor = Executor(2)});
  ASSERT_TRUE(one && two) << to_text(diagnostics);
  testing::expect_same(*one, *two, true);
  const auto as_gltf = [](const Scene& scene) {
    Diagnostics notes;
    return encode_gltf(scene, "out.glb", notes, {.compression = Compression::none})->front().bytes;
  };
  EXPECT_EQ(as_gltf(*one), as_gltf(*two));
}

TEST(GltfDraco, primitives_of_one_buffer_share_what_comes_out) {
  GltfBuilder coded = draco_compressed(ribbon(20));
  GltfJson second = primitive(coded);
  second["extensions"][extension]["attributes"].erase("TEXCOORD_0");
  second["attributes"].erase("TEXCOORD_0");
  coded.json["meshes"][0]["primitives"].push_back(second);
  const Scene scene = testing::read(coded);
  ASSERT_EQ(scene.draws.size(), 2u);
  EXPECT_EQ(stream(scene, 0, "POSITION").bytes.view().data(), stream(scene, 1, "POSITION").bytes.view().data());
  EXPECT_EQ(indices_of(scene, 0), indices_of(scene, 1));
}

TEST(GltfDraco, accessors_that_stand_for_two_buffers_become_two) {
  GltfBuilder coded = draco_compressed(ribbon(20));
  const GltfBuilder other = draco_compressed(ribbon(20), {.bits = 4});
  GltfJson second = primitive(coded);
  const std::size_t from = primitive(coded)["extensions"][extension]["bufferView"];
  second["extensions"][extension]["bufferView"] = coded.add_view(testing::view_bytes(other, from));
  coded.json["meshes"][0]["primitives"].push_back(second);
  const Scene scene = testing::read(coded);
  testing::expect_same({.draws = {scene.draws[0]}}, {.draws = {testing::read(draco_compressed(ribbon(20))).draws[0]}},
                       true);
  testing::expect_same({.draws = {scene.draws[1]}}, {.draws = {testing::read(other).draws[0]}}, true);
}

TEST(GltfDraco, a_strip_is_read_as_a_list) {
  GltfBuilder coded = draco_compressed(ribbon(20), {.sequential = true});
  primitive(coded)["mode"] = 5;
  coded.json["accessors"][primitive(coded)["indices"].get<std::size_t>()]["count"] = 42;
  const Scene scene = testing::read(coded);
  EXPECT_EQ(indices_of(scene, 0), indices_of(testing::read(ribbon(20)), 0));
  EXPECT_EQ(scene.draws[0].topology, Topology::triangles);
}

TEST(GltfDraco, counts_from_before_encoding_are_told_and_the_buffer_is_believed) {
  GltfBuilder plain = ribbon(20);
  const std::vector<std::uint16_t> flat{3, 3, 5};  // no area, which the encoder leaves out
  std::vector<std::uint16_t> indices;
  for (const std::uint32_t i : indices_of(testing::read(plain), 0)) indices.push_back(static_cast<std::uint16_t>(i));
  indices.insert(indices.end(), flat.begin(), flat.end());
  primitive(plain)["indices"] = plain.add_values(indices, "SCALAR");
  const GltfBuilder coded = draco_compressed(plain, {.counted_before = true});
  Diagnostics diagnostics;
  const auto scene = read_gltf(coded.glb(), "test", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "compressed-count");
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::warning);
  EXPECT_NE(diagnostics.all()[0].message.find("claim 42 vertices and 41 triangles"), std::string::npos)
      << diagnostics.all()[0].message;
  EXPECT_EQ(scene->draws[0].levels[0].orders[0].triangle_count(), 40u);
}

TEST(GltfDraco, indices_become_wider_where_the_buffer_names_more_vertices) {
  GltfBuilder coded = draco_compressed(ribbon(200), {.sequential = true});
  coded.json["accessors"][primitive(coded)["indices"].get<std::size_t>()]["componentType"] = 5121;
  EXPECT_EQ(indices_of(testing::read(coded), 0), indices_of(testing::read(ribbon(200)), 0));
}

TEST(GltfDraco, a_file_that_nothing_changes_stays_as_it_came) {
  for (const bool plain_copy : {false, true}) {
    const auto file = draco_compressed(puppet(), {.sequential = true, .plain_copy = plain_copy}).glb();
    EXPECT_EQ(testing::write(testing::read(file)), file) << plain_copy;
  }
}

/// Written with a note, and read again.
struct Written {
  GltfJson json;
  Diagnostics diagnostics;
  Scene scene;
  std::size_t bytes = 0;
};

Written rewritten(const Scene& scene, Compression compression = Compression::keep) {
  Written result;
  const auto files = encode_gltf(scene, "out.glb", result.diagnostics, {.compression = compression});
  result.json = testing::json_of(files->front().bytes);
  result.bytes = files->front().bytes.size();
  result.scene = testing::read(files->front().bytes);
  return result;
}

TEST(GltfDraco, a_change_is_written_plain_and_nothing_of_draco_is_left) {
  GltfBuilder plain = many_attributes();
  plain.json["extensionsUsed"] = {"KHR_materials_unlit"};
  for (const bool plain_copy : {false, true}) {
    const auto file = draco_compressed(plain, {.bits = 14, .plain_copy = plain_copy}).glb();
    Scene scene = testing::read(file);
    testing::reverse(scene.draws[0]);
    const Written is = rewritten(scene);
    testing::expect_same(is.scene, scene, true);
    EXPECT_EQ(is.json.dump().find("draco"), std::string::npos);
    EXPECT_EQ(is.json["extensionsUsed"], GltfJson::array({"KHR_materials_unlit"}));
    EXPECT_FALSE(is.json.contains("extensionsRequired"));
    ASSERT_FALSE(is.diagnostics.empty());
    EXPECT_EQ(is.diagnostics.all()[0].code, "draco-decompressed");
    EXPECT_EQ(is.diagnostics.all()[0].severity, Severity::note);
    std::size_t held = 0;
    for (const GltfJson& view : is.json["bufferViews"]) held += view["byteLength"].get<std::size_t>();
    EXPECT_LT(held, 62 * 100 + 360u) << "neither Draco's buffer nor the plain copy is there any more";
  }
}

TEST(GltfDraco, a_plain_file_may_be_asked_for_and_a_note_says_what_it_costs) {
  const auto file = draco_compressed(ribbon(300), {.bits = 11}).glb();
  const Scene scene = testing::read(file);
  const Written is = rewritten(scene, Compression::none);
  testing::expect_same(is.scene, scene, true);
  EXPECT_FALSE(is.json.contains("extensionsUsed"));
  ASSERT_EQ(is.diagnostics.all().size(), 2u);
  EXPECT_NE(is.diagnostics.all()[0].message.find("bytes of geometry become 15,640"), std::string::npos)
      << is.diagnostics.all()[0].message;
  EXPECT_EQ(is.diagnostics.all()[1].code, "output-grew");
  EXPECT_NE(is.diagnostics.all()[1].hint.find("Draco"), std::string::npos) << is.diagnostics.all()[1].hint;
}

TEST(GltfDraco, ranges_that_were_told_before_encoding_become_exact) {
  GltfBuilder plain = ribbon(20);
  plain.json["accessors"][0]["min"] = {-0.5, -0.5, 0};
  plain.json["accessors"][0]["max"] = {99, 99, 0};
  const Scene scene = testing::read(draco_compressed(plain, {.bits = 8}));
  const Written is = rewritten(scene, Compression::none);
  const auto positions = stream(scene, 0, "POSITION");
  float most = 0;
  for (std::size_t i = 0; i < positions.count(); ++i) most = std::max(most, decode_component(positions, i, 0));
  EXPECT_EQ(is.json["accessors"][0]["max"][0].get<float>(), most);
}

TEST(GltfDraco, unknown_extensions_and_draco_go_together) {
  GltfBuilder coded = draco_compressed(ribbon(20));
  coded.json["extensions"]["ACME_teapots"] = {{"bufferView", 0}};
  coded.json["extensionsUsed"].push_back("ACME_teapots");
  Scene scene = testing::read(coded);
  testing::reverse(scene.draws[0]);
  const Written is = rewritten(scene);
  testing::expect_same(is.scene, scene, true);
  EXPECT_EQ(is.json["extensionsUsed"], GltfJson::array({"ACME_teapots"}));
}

}  // namespace
}  // namespace foredraw::draco_test
