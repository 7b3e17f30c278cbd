// Every rule of the gate breaks a sound file in one place and is told by its code and place.
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/gltf_builder.h"
#include "support/meshes.h"

namespace foredraw::gate_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

Diagnostics refusal(std::span<const std::byte> bytes) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf({bytes.begin(), bytes.end()}, "broken", {}, diagnostics).has_value());
  return diagnostics;
}

bool tells(const Diagnostics& diagnostics, const std::string& code, const std::string& inside) {
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.code == code && d.where.inside == inside && d.where.file == "broken" && d.severity == Severity::error)
      return true;
  }
  return false;
}

struct Rule {
  const char* name;
  std::function<void(GltfBuilder&)> breaks;
  const char* code;
  const char* inside;
};

void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.name; }

class GateRule : public ::testing::TestWithParam<Rule> {};

/// The puppet's accessors: 0 positions, 1 uvs, 2 indices, 3 joints, 4 weights, 5 target, 6 matrices, 7 times, 8 turns,
/// 9 morph weights. Its views: as many, and 6 and 7 for the sparse elements, 8 for the picture.
GltfJson& item(GltfBuilder& b, const char* kind, std::size_t i) { return b.json[kind][i]; }
GltfJson& primitive(GltfBuilder& b) { return b.json["meshes"][0]["primitives"][0]; }
GltfJson& instancing(GltfBuilder& b) { return b.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]; }

template <class T>
void poke(GltfBuilder& b, std::size_t accessor, std::size_t element, T value) {
  const GltfJson& view = b.json["bufferViews"][b.json["accessors"][accessor]["bufferView"].get<std::size_t>()];
  std::memcpy(b.buffer.data() + view["byteOffset"].get<std::size_t>() + element * sizeof(T), &value, sizeof(T));
}

const double huge = 1099511627776.0;  // 2^40
const std::int64_t two_to_40 = std::int64_t{1} << 40;

const Rule rules[] = {
    {"version_1", [](auto& b) { b.json["asset"]["version"] = "1.0"; }, "gltf-version", "asset.version"},
    {"no_asset", [](auto& b) { b.json.erase("asset"); }, "missing-member", "the file"},
    {"kind_is_no_array", [](auto& b) { b.json["nodes"] = 7; }, "wrong-type", "nodes"},
    {"node_is_no_object", [](auto& b) { b.json["nodes"][1] = 7; }, "wrong-type", "nodes[1]"},
    {"buffer_without_length", [](auto& b) { b.json["buffers"] = {GltfJson::object()}; }, "missing-member",
     "buffers[0]"},
    {"buffer_negative",
     [](auto& b) {
       b.json["buffers"] = {{{"byteLength", -1}}};
     },
     "out-of-range", "buffers[0].byteLength"},
    {"second_buffer_has_no_data",
     [](auto& b) {
       b.json["buffers"] = {{{"byteLength", b.buffer.size()}}, {{"byteLength", 8}}};
     },
     "buffer-missing", "buffers[1]"},
    {"view_of_no_buffer", [](auto& b) { item(b, "bufferViews", 0)["buffer"] = 3; }, "bad-reference",
     "bufferViews[0].buffer"},
    {"view_behind_its_buffer", [](auto& b) { item(b, "bufferViews", 0)["byteOffset"] = b.buffer.size(); }, "view-range",
     "bufferViews[0].byteLength"},
    {"view_overflows",
     [](auto& b) {
       item(b, "bufferViews", 0)["byteOffset"] = std::numeric_limits<std::int64_t>::max();
       item(b, "bufferViews", 0)["byteLength"] = std::numeric_limits<std::int64_t>::max();
     },
     "view-range", "bufferViews[0].byteLength"},
    {"view_stride_odd", [](auto& b) { item(b, "bufferViews", 0)["byteStride"] = 14; }, "view-stride",
     "bufferViews[0].byteStride"},
    {"stride_below_element", [](auto& b) { item(b, "bufferViews", 0)["byteStride"] = 8; }, "view-stride",
     "accessors[0].bufferView"},
    {"accessor_of_no_view", [](auto& b) { item(b, "accessors", 0)["bufferView"] = 99; }, "bad-reference",
     "accessors[0].bufferView"},
    {"accessor_type", [](auto& b) { item(b, "accessors", 0)["type"] = "VEC5"; }, "accessor-type", "accessors[0]"},
    {"accessor_component_type", [](auto& b) { item(b, "accessors", 0)["componentType"] = 5124; }, "accessor-type",
     "accessors[0]"},
    {"accessor_count_is_a_fraction", [](auto& b) { item(b, "accessors", 0)["count"] = 1.5; }, "wrong-type",
     "accessors[0].count"},
    {"accessor_count_2_40", [](auto& b) { item(b, "accessors", 0)["count"] = two_to_40; }, "accessor-range",
     "accessors[0].count"},
    {"accessor_count_2_40_as_float", [](auto& b) { item(b, "accessors", 0)["count"] = huge; }, "wrong-type",
     "accessors[0].count"},
    {"accessor_one_too_many", [](auto& b) { item(b, "accessors", 0)["count"] = 11; }, "accessor-range",
     "accessors[0].count"},
    {"accessor_empty", [](auto& b) { item(b, "accessors", 0)["count"] = 0; }, "out-of-range", "accessors[0].count"},
    {"accessor_offset_outside", [](auto& b) { item(b, "accessors", 0)["byteOffset"] = 4000; }, "accessor-range",
     "accessors[0].count"},
    {"zeros_without_end",
     [](auto& b) {
       item(b, "skins", 0)["inverseBindMatrices"] =
           b.add("accessors", {{"componentType", 5126}, {"type", "MAT4"}, {"count", 100'000'000}});
     },
     "accessor-range", "accessors[10].count"},
    {"sparse_not_rising",
     [](auto& b) {
       std::memset(b.buffer.data() + item(b, "bufferViews", 6)["byteOffset"].template get<std::size_t>(), 1, 4);
     },
     "sparse-indices", "accessors[5].sparse.indices"},
    {"sparse_outside",
     [](auto& b) {
       std::memset(b.buffer.data() + item(b, "bufferViews", 6)["byteOffset"].template get<std::size_t>() + 4, 100, 1);
     },
     "sparse-indices", "accessors[5].sparse.indices"},
    {"sparse_more_than_elements", [](auto& b) { item(b, "accessors", 5)["sparse"]["count"] = 11; }, "out-of-range",
     "accessors[5].sparse.count"},
    {"image_view", [](auto& b) { item(b, "images", 0)["bufferView"] = 99; }, "bad-reference", "images[0].bufferView"},
    {"image_two_sources", [](auto& b) { item(b, "images", 0)["uri"] = "a.png"; }, "image-source", "images[0]"},
    {"primitive_without_attributes", [](auto& b) { primitive(b)["attributes"] = GltfJson::object(); }, "out-of-range",
     "meshes[0].primitives[0].attributes"},
    {"attribute_accessor", [](auto& b) { primitive(b)["attributes"]["TEXCOORD_0"] = 99; }, "bad-reference",
     "meshes[0].primitives[0].attributes.TEXCOORD_0"},
    {"attribute_count", [](auto& b) { item(b, "accessors", 1)["count"] = 9; }, "unequal-counts",
     "meshes[0].primitives[0].attributes.TEXCOORD_0"},
    {"target_count",
     [](auto& b) {
       item(b, "accessors", 5)["count"] = 10;
       primitive(b)["targets"][0]["POSITION"] = 7;
     },
     "unequal-counts", "meshes[0].primitives[0].targets[0].POSITION"},
    {"position_is_vec2", [](auto& b) { primitive(b)["attributes"]["POSITION"] = 1; }, "attribute-type",
     "meshes[0].primitives[0].attributes.POSITION"},
    {"indices_accessor", [](auto& b) { primitive(b)["indices"] = 99; }, "bad-reference",
     "meshes[0].primitives[0].indices"},
    {"indices_are_vectors", [](auto& b) { primitive(b)["indices"] = 0; }, "index-type",
     "meshes[0].primitives[0].indices"},
    {"indices_are_signed", [](auto& b) { item(b, "accessors", 2)["componentType"] = 5122; }, "index-type",
     "meshes[0].primitives[0].indices"},
    {"index_too_great", [](auto& b) { poke<std::uint16_t>(b, 2, 5, 10); }, "index-range",
     "meshes[0].primitives[0].indices"},
    {"index_restarts", [](auto& b) { poke<std::uint16_t>(b, 2, 5, 0xffff); }, "primitive-restart",
     "meshes[0].primitives[0].indices"},
    {"mode_7", [](auto& b) { primitive(b)["mode"] = 7; }, "out-of-range", "meshes[0].primitives[0].mode"},
    {"attribute_of_unknown_type",
     [](auto& b) {
       primitive(b)["attributes"]["TEXCOORD_1"] =
           b.add("accessors", {{"componentType", 5126}, {"type", "VEC5"}, {"count", 10}});
     },
     "accessor-type", "accessors[10]"},
    {"primitive_material", [](auto& b) { primitive(b)["material"] = 1; }, "bad-reference",
     "meshes[0].primitives[0].material"},
    {"node_mesh", [](auto& b) { item(b, "nodes", 0)["mesh"] = 1; }, "bad-reference", "nodes[0].mesh"},
    {"node_skin", [](auto& b) { item(b, "nodes", 0)["skin"] = 1; }, "bad-reference", "nodes[0].skin"},
    {"node_child", [](auto& b) { item(b, "nodes", 1)["children"] = {3}; }, "bad-reference", "nodes[1].children[0]"},
    {"node_cycle", [](auto& b) { item(b, "nodes", 2)["children"] = {1}; }, "node-cycle", "nodes[1]"},
    {"node_is_its_own_child", [](auto& b) { item(b, "nodes", 0)["children"] = {0}; }, "node-cycle", "nodes[0]"},
    {"node_two_parents", [](auto& b) { item(b, "nodes", 0)["children"] = {2}; }, "node-parents", "nodes[1].children"},
    {"node_matrix_short",
     [](auto& b) {
       item(b, "nodes", 0)["matrix"] = {1, 0};
     },
     "out-of-range", "nodes[0].matrix"},
    {"node_translation_huge",
     [](auto& b) {
       item(b, "nodes", 0)["translation"] = {1e300, 0, 0};
     },
     "wrong-type", "nodes[0].translation[0]"},
    {"scene_node", [](auto& b) { item(b, "scenes", 0)["nodes"] = {9}; }, "bad-reference", "scenes[0].nodes[0]"},
    {"skin_without_joints", [](auto& b) { item(b, "skins", 0)["joints"] = GltfJson::array(); }, "out-of-range",
     "skins[0].joints"},
    {"skin_joint",
     [](auto& b) {
       item(b, "skins", 0)["joints"] = {1, 9};
     },
     "bad-reference", "skins[0].joints[1]"},
    {"skin_matrices", [](auto& b) { item(b, "accessors", 6)["count"] = 1; }, "unequal-counts",
     "skins[0].inverseBindMatrices"},
    {"joint_of_no_skin", [](auto& b) { poke<std::uint8_t>(b, 3, 7, 2); }, "joint-range", "nodes[0]"},
    {"instancing_is_no_object", [](auto& b) { instancing(b) = 3; }, "wrong-type",
     "nodes[0].extensions.EXT_mesh_gpu_instancing"},
    {"instancing_lacks_attributes", [](auto& b) { instancing(b) = GltfJson::object(); }, "missing-member",
     "nodes[0].extensions.EXT_mesh_gpu_instancing"},
    {"instancing_of_nothing", [](auto& b) { instancing(b)["attributes"] = GltfJson::object(); }, "out-of-range",
     "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes"},
    {"instancing_reference", [](auto& b) { instancing(b)["attributes"]["_ID"] = 99; }, "bad-reference",
     "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes._ID"},
    {"instancing_type", [](auto& b) { instancing(b)["attributes"]["SCALE"] = 1; }, "accessor-type",
     "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE"},
    {"instancing_turn", [](auto& b) { instancing(b)["attributes"]["ROTATION"] = 0; }, "accessor-type",
     "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.ROTATION"},
    {"instancing_counts",
     [](auto& b) {
       instancing(b)["attributes"] = {{"_ID", 0}, {"_OTHER", 7}};
     },
     "unequal-counts", "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes._OTHER"},
    {"times_are_nan", [](auto& b) { poke<float>(b, 7, 1, std::numeric_limits<float>::quiet_NaN()); }, "animation-times",
     "animations[0].samplers[0].input"},
    {"values_are_infinite", [](auto& b) { poke<float>(b, 8, 1, std::numeric_limits<float>::infinity()); }, "non-finite",
     "accessors[8]"},
    {"cubic_needs_three", [](auto& b) { item(b, "animations", 0)["samplers"][0]["interpolation"] = "CUBICSPLINE"; },
     "animation-count", "animations[0].channels[0]"},
    {"channel_sampler", [](auto& b) { item(b, "animations", 0)["channels"][0]["sampler"] = 2; }, "bad-reference",
     "animations[0].channels[0].sampler"},
    {"channel_path", [](auto& b) { item(b, "animations", 0)["channels"][0]["target"]["path"] = "colour"; },
     "out-of-range", "animations[0].channels[0].target.path"},
    {"channel_type", [](auto& b) { item(b, "animations", 0)["channels"][0]["target"]["path"] = "scale"; },
     "accessor-type", "animations[0].channels[0]"},
};

TEST_P(GateRule, is_told_by_code_and_place) {
  GltfBuilder builder = testing::puppet();
  GetParam().breaks(builder);
  const Diagnostics diagnostics = refusal(builder.glb());
  EXPECT_TRUE(tells(diagnostics, GetParam().code, GetParam().inside))
      << "wanted " << GetParam().code << " at " << GetParam().inside << ", got\n"
      << to_text(diagnostics);
}

INSTANTIATE_TEST_SUITE_P(Gltf, GateRule, ::testing::ValuesIn(rules),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(GltfGate, sound_puppet_is_read) {
  Diagnostics diagnostics;
  EXPECT_TRUE(read_gltf(testing::puppet().glb(), "puppet", {}, diagnostics)) << to_text(diagnostics);
  EXPECT_TRUE(read_gltf(testing::puppet().gltf(), "puppet", {}, diagnostics)) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(GltfGate, all_mistakes_are_told_each_kind_once) {
  GltfBuilder builder = testing::puppet();
  builder.json["accessors"][1]["bufferView"] = 99;
  builder.json["skins"][0]["joints"] = {1, 900};
  builder.json["nodes"][0]["mesh"] = 5;
  EXPECT_EQ(refusal(builder.glb()).all().size(), 3u);
  for (int i = 0; i < 50; ++i) builder.add("nodes", {{"mesh", 7}});
  const Diagnostics many = refusal(builder.glb());
  ASSERT_EQ(many.all().size(), 3u) << to_text(many);
  EXPECT_NE(to_text(many).find("nodes[0].mesh: is 5, but the file has 1 meshes (and 50 more like it)"),
            std::string::npos)
      << to_text(many);
}

TEST(GltfGate, a_file_that_is_all_mistakes_is_refused_in_a_few_lines) {
  GltfBuilder builder = testing::puppet();
  GltfJson attributes = {{"POSITION", 0}};
  for (int i = 0; i < 30; ++i) attributes["_" + std::string(1, static_cast<char>('A' + i))] = 99;
  primitive(builder)["attributes"] = attributes;
  const Diagnostics many = refusal(builder.glb());
  ASSERT_EQ(many.all().size(), 21u);
  EXPECT_EQ(many.all().back().code, "more-mistakes");
  EXPECT_NE(many.all().back().message.find("10 more kinds"), std::string::npos);
}

TEST(GltfGate, vertex_data_may_hold_what_is_no_number) {
  GltfBuilder builder = testing::puppet();
  poke<float>(builder, 0, 4, std::numeric_limits<float>::quiet_NaN());
  Diagnostics diagnostics;
  EXPECT_TRUE(read_gltf(builder.glb(), "puppet", {}, diagnostics)) << to_text(diagnostics);
}

TEST(GltfGate, the_largest_float_is_one) {
  GltfBuilder builder = testing::puppet();
  item(builder, "materials", 0)["alphaCutoff"] = std::numeric_limits<float>::max();
  Diagnostics diagnostics;
  EXPECT_TRUE(read_gltf(builder.glb(), "puppet", {}, diagnostics, {.strict = true})) << to_text(diagnostics);
  item(builder, "materials", 0)["alphaCutoff"] = 1e39;
  EXPECT_FALSE(read_gltf(builder.glb(), "puppet", {}, diagnostics, {.strict = true}));
}

/// What is harmless is told and read, and comes out again as it was.
struct Harmless {
  const char* name;
  std::function<void(GltfBuilder&)> breaks;
  const char* code;
};

void PrintTo(const Harmless& harmless, std::ostream* out) { *out << harmless.name; }

class HarmlessOddity : public ::testing::TestWithParam<Harmless> {};

TEST_P(HarmlessOddity, is_told_and_kept) {
  GltfBuilder builder = testing::puppet();
  GetParam().breaks(builder);
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "odd", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::warning);
  EXPECT_EQ(diagnostics.all()[0].code, GetParam().code);
  const auto files = encode_gltf(*scene, "out.gltf", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  const GltfJson json = testing::json_of(files->front().bytes);
  EXPECT_EQ(json["meshes"], builder.json["meshes"]);
  EXPECT_EQ(json["accessors"].size(), builder.json["accessors"].size());
}

INSTANTIATE_TEST_SUITE_P(Gltf, HarmlessOddity,
                         ::testing::Values(Harmless{"primitive_without_positions",
                                                    [](auto& b) {
                                                      GltfJson other = primitive(b);
                                                      other["attributes"].erase("POSITION");
                                                      b.json["meshes"][0]["primitives"].push_back(other);
                                                    },
                                                    "no-position"},
                                           Harmless{"corners_left_over",
                                                    [](auto& b) { item(b, "accessors", 2)["count"] = 23; },
                                                    "index-count"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(GltfGate, corners_left_over_are_not_drawn) {
  GltfBuilder builder = testing::puppet();
  item(builder, "accessors", 2)["count"] = 23;
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "odd", {}, diagnostics);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->draws[0].levels[0].orders[0].indices.size(), 21u);
}

}  // namespace
}  // namespace foredraw::gate_test
