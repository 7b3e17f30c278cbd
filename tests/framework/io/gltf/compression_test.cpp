// Compressed files read as their plain ones are, and are written back compressed: what changed anew, all else as it
// came.
#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <string>

#include "framework/io/gltf/compressed_scenes.h"

#include "support/meshes.h"

namespace foredraw::compression_test {
namespace {

using testing::Bytes;
using testing::CompressionChoice;
using testing::encode;
using testing::expect_same;
using testing::extension;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::stream_of;
using testing::Written;
using Plain = CompressionChoice::Plain;

struct Case {
  std::string extension;
  Plain plain;
  bool triangles;
};

class EveryKind : public ::testing::TestWithParam<Case> {
 protected:
  static CompressionChoice choice() { return {GetParam().extension, GetParam().plain, GetParam().triangles, {}}; }
};

TEST_P(EveryKind, is_read_as_the_plain_file_is) {
  const GltfBuilder plain = testing::puppet();
  const GltfBuilder made = testing::compressed(plain, choice());
  expect_same(testing::read(made), testing::read(plain), !GetParam().triangles);
}

TEST_P(EveryKind, comes_out_as_it_came_where_nothing_changed) {
  const Bytes file = testing::compressed(testing::puppet(), choice()).glb();
  EXPECT_EQ(testing::write(testing::read(file)), file);
}

TEST_P(EveryKind, is_compressed_again_where_it_changed_and_else_stays) {
  const Bytes file = testing::compressed(testing::puppet(), choice()).glb();
  Scene scene = testing::read(file);
  testing::reverse(scene.draws[0]);
  testing::reverse_vertices(scene, 0);
  const Written written = encode(scene);
  const Bytes& again = written.files.front().bytes;
  const char* name = GetParam().extension.c_str();
  const GltfJson& json = written.json;
  const GltfJson was = testing::json_of(file);
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    EXPECT_EQ(json.value(list, GltfJson()), was.value(list, GltfJson()));
  // The plain views of the sparse elements are gone, so that what follows has other numbers.
  for (std::size_t v = 0; v < 5; ++v)
    EXPECT_EQ(extension(json, v, name)["count"], extension(was, v, name)["count"]) << v;
  const auto compressed = [&](const GltfJson& views) {
    return std::ranges::count_if(views, [](const GltfJson& view) { return view.contains("extensions"); });
  };
  EXPECT_EQ(compressed(json["bufferViews"]), compressed(was["bufferViews"]));
  // The plain copies are where they were: nowhere, in a buffer of their own, or beside the streams.
  const bool apart = GetParam().plain != Plain::beside;
  EXPECT_EQ(json["buffers"].size(), apart ? 2u : 1u);
  EXPECT_EQ(written.files.size(), GetParam().plain == Plain::data_uri ? 2u : 1u);
  if (GetParam().plain == Plain::none) {
    expect_same(testing::read(again), scene, !GetParam().triangles);
    EXPECT_EQ(json["buffers"][1]["byteLength"], was["buffers"][1]["byteLength"]);
    EXPECT_EQ(json["buffers"][1]["extensions"][name]["fallback"], true);
    EXPECT_FALSE(json["buffers"][1].contains("uri"));
  }
  if (GetParam().plain == Plain::data_uri) {
    EXPECT_EQ(written.files[1].path, "out.glb.fallback.bin");
    EXPECT_EQ(json["buffers"][1]["uri"], "out.glb.fallback.bin");
    EXPECT_EQ(json["buffers"][1]["byteLength"], written.files[1].bytes.size());
  }
  if (GetParam().plain == Plain::beside) {
    expect_same(testing::read(again), scene, !GetParam().triangles);
    GltfBuilder uncompressed = testing::builder_of(again);
    for (GltfJson& view : uncompressed.json["bufferViews"]) view.erase("extensions");
    expect_same(testing::read(uncompressed), scene, true);
  }
}

std::string case_name(const ::testing::TestParamInfo<Case>& info) {
  const Plain plain = info.param.plain;
  const char* copy = plain == Plain::none ? "" : plain == Plain::beside ? "_beside_plain" : "_in_data_uri";
  return info.param.extension.substr(0, 3) + copy + (info.param.triangles ? "" : "_as_indices");
}

INSTANTIATE_TEST_SUITE_P(Gltf, EveryKind,
                         ::testing::Values(Case{"EXT_meshopt_compression", Plain::none, true},
                                           Case{"KHR_meshopt_compression", Plain::none, true},
                                           Case{"EXT_meshopt_compression", Plain::none, false},
                                           Case{"EXT_meshopt_compression", Plain::data_uri, true},
                                           Case{"KHR_meshopt_compression", Plain::beside, true}),
                         case_name);

TEST(GltfCompression, streams_that_nobody_changed_keep_their_bytes) {
  const Bytes file = testing::compressed(testing::puppet()).glb();
  Scene scene = testing::read(file);
  testing::reverse(scene.draws[0]);
  const Bytes again = testing::write(scene);
  const GltfJson json = testing::json_of(file);
  for (std::size_t v = 0; v < json["bufferViews"].size(); ++v) {
    if (json["bufferViews"][v].contains("extensions")) {
      EXPECT_EQ(stream_of(again, v) == stream_of(file, v), v != 2) << v;
    }
  }
}

TEST(GltfCompression, filters_stay_where_vertices_only_moved) {
  Scene scene = testing::read(testing::with_filters());
  testing::reverse_vertices(scene, 0);
  const Written written = encode(scene);
  EXPECT_EQ(extension(written.json, 0)["filter"], "EXPONENTIAL");
  EXPECT_EQ(extension(written.json, 3)["filter"], "OCTAHEDRAL");
  EXPECT_EQ(extension(written.json, 4)["filter"], "QUATERNION");
  expect_same(testing::read(written.files.front().bytes), scene);
}

TEST(GltfCompression, new_values_lose_the_filter_and_nothing_else) {
  Scene scene = testing::read(testing::with_filters());
  VertexStream positions = testing::stream(scene, 0, "POSITION");
  Bytes bytes(positions.bytes.view().begin(), positions.bytes.view().end());
  const float value = 0.1234567f;
  std::memcpy(bytes.data() + 12, &value, 4);
  positions.bytes = Shared<std::byte>(std::move(bytes));
  Level& level = scene.draws[0].levels[0];
  level.vertices = std::make_shared<VertexStreams>(testing::with_stream(scene, 0, positions));
  const Written written = encode(scene);
  EXPECT_EQ(extension(written.json, 0)["filter"], "NONE");
  EXPECT_EQ(extension(written.json, 3)["filter"], "OCTAHEDRAL");
  expect_same(testing::read(written.files.front().bytes), scene);
}

TEST(GltfCompression, is_left_off_where_that_is_asked_and_the_growth_is_told) {
  const Bytes file = testing::compressed(testing::ribbon(500)).glb();
  const Scene scene = testing::read(file);
  const Written written = encode(scene, Compression::none);
  EXPECT_EQ(testing::read(written.files[0].bytes).draws.size(), 1u);
  expect_same(testing::read(written.files[0].bytes), scene, true);
  EXPECT_EQ(written.json["buffers"].size(), 1u);
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) EXPECT_FALSE(written.json.contains(list)) << list;
  for (const GltfJson& view : written.json["bufferViews"]) EXPECT_FALSE(view.contains("extensions"));
  ASSERT_EQ(written.diagnostics.all().size(), 1u);
  const Diagnostic& note = written.diagnostics.all()[0];
  EXPECT_EQ(note.code, "output-grew");
  EXPECT_EQ(note.message, "the output has " + counted(written.files[0].bytes.size()) + " bytes; the input had " +
                              counted(file.size()));
  EXPECT_EQ(note.hint.find("data written uncompressed: "), 0u) << note.hint;
}

TEST(GltfCompression, does_not_grow_by_an_order_that_compresses_as_well) {
  const Bytes file = testing::compressed(testing::ribbon(500)).glb();
  Scene scene = testing::read(file);
  testing::reverse(scene.draws[0]);
  EXPECT_LT(testing::write(scene).size(), file.size() + file.size() / 10);
}

TEST(GltfCompression, what_grows_names_what_grew) {
  Scene scene = testing::read(testing::ribbon(4));
  testing::reverse(scene.draws[0]);
  scene.draws[0].name = "x";
  scene.meshes[0].name = "a name that was not there before";
  const Written written = encode(scene);
  ASSERT_EQ(written.diagnostics.all().size(), 1u);
  EXPECT_EQ(written.diagnostics.all()[0].code, "output-grew");
  EXPECT_NE(written.diagnostics.all()[0].hint.find("JSON and padding"), std::string::npos);
}

TEST(GltfCompression, draws_that_part_ways_are_both_compressed) {
  Scene scene = testing::read(testing::compressed(testing::sharing()));
  testing::reverse(scene.draws[1]);
  const Written written = encode(scene);
  EXPECT_EQ(written.json["accessors"].size(), 4u);
  for (const GltfJson& view : written.json["bufferViews"]) EXPECT_TRUE(view.contains("extensions")) << view.dump();
  expect_same(testing::read(written.files[0].bytes), scene);
}

TEST(GltfCompression, several_meshes_in_one_view_of_narrow_indices_stay_tight) {
  GltfBuilder plain = testing::ribbon(3);
  GltfJson& json = plain.json;  // two draws from one index view, the second from its fourth triangle on
  json["accessors"].push_back(json["accessors"][2]);
  json["accessors"][2]["count"] = 9;
  json["accessors"][3]["count"] = 9;
  json["accessors"][3]["byteOffset"] = 18;
  json["meshes"][0]["primitives"].push_back(json["meshes"][0]["primitives"][0]);
  json["meshes"][0]["primitives"][1]["indices"] = 3;
  const Bytes file = testing::compressed(plain).glb();
  for (const bool both : {false, true}) {
    Scene scene = testing::read(file);
    testing::reverse(scene.draws[0]);
    if (both) testing::reverse(scene.draws[1]);
    const Written written = encode(scene);
    EXPECT_EQ(extension(written.json, 2)["count"], 18) << "no gap between the draws";
    expect_same(testing::read(written.files[0].bytes), scene);
  }
}

class OfTheCorpus : public ::testing::TestWithParam<const char*> {};

TEST_P(OfTheCorpus, compressed_models_are_read_as_the_plain_ones_and_stay_small) {
  Diagnostics diagnostics;
  const auto file = read_file(testing::project_file(std::string("benchmarks/corpus/") + GetParam()), diagnostics);
  ASSERT_TRUE(file);
  const Bytes small = testing::compressed(testing::builder_of(*file)).glb();
  EXPECT_LT(small.size(), file->size());
  Scene scene = testing::read(small);
  expect_same(scene, testing::read(*file));
  EXPECT_EQ(testing::write(scene), small);
  for (Draw& draw : scene.draws) testing::reverse(draw);
  const Bytes again = testing::write(scene);
  expect_same(testing::read(again), scene);
  EXPECT_LT(again.size(), small.size() + small.size() / 4);
}

INSTANTIATE_TEST_SUITE_P(Gltf, OfTheCorpus,
                         ::testing::Values("static/spot.glb", "static/head.glb", "animated/fox.glb",
                                           "animated/robot_expressive.glb", "scenes/house.glb"),
                         [](const auto& info) { return std::to_string(info.index); });

class AsToolsMakeThem : public ::testing::TestWithParam<const char*> {};

TEST_P(AsToolsMakeThem, are_read_and_written_compressed) {
  Diagnostics diagnostics;
  auto scene = read_gltf(testing::project_file(std::string("tests/compressed/") + GetParam()), diagnostics);
  ASSERT_TRUE(scene && diagnostics.empty()) << to_text(diagnostics);
  for (const Draw& draw : scene->draws) {
    const VertexStream* normals = draw.levels[0].vertices->find("NORMAL");
    for (std::size_t i = 0; normals != nullptr && i < normals->count(); ++i) {
      float length = 0;
      for (std::size_t c = 0; c < 3; ++c) length += std::pow(decode_component(*normals, i, c), 2.0f);
      ASSERT_NEAR(length, 1, 0.03) << draw.name << ' ' << i;
    }
  }
  for (const AnimationChannel& channel :
       scene->animations.empty() ? std::vector<AnimationChannel>() : scene->animations[0].channels) {
    const auto values = channel.values.view();
    for (std::size_t i = 0; channel.path == AnimatedPath::rotation && i < values.size(); i += 4) {
      float length = 0;
      for (std::size_t c = 0; c < 4; ++c) length += values[i + c] * values[i + c];
      ASSERT_NEAR(length, 1, 0.001);
    }
  }
  for (std::size_t d = 0; d < scene->draws.size(); ++d) {
    testing::reverse(scene->draws[d]);
    testing::reverse_vertices(*scene, d);
  }
  EXPECT_EQ(encode(*scene, Compression::none).json.dump().find("meshopt"), std::string::npos);
  const Written written = encode(*scene, Compression::keep, "out.glb");
  if (written.files.size() == 1) expect_same(testing::read(written.files[0].bytes), *scene);
  std::map<std::string, int> filters;
  for (const GltfJson& view : written.json["bufferViews"]) {
    if (view.contains("extensions")) ++filters[view["extensions"].front().value("filter", "NONE")];
  }
  const std::map<std::string, std::map<std::string, int>> expected = {
      {"spot.glb", {{"NONE", 2}, {"OCTAHEDRAL", 1}}},
      {"spot_khr.glb", {{"NONE", 2}}},
      {"spot_fallback.gltf", {{"NONE", 2}}},
      {"robot.glb", {{"NONE", 7}, {"OCTAHEDRAL", 1}, {"EXPONENTIAL", 1}, {"QUATERNION", 1}}},
      {"rover.glb", {{"NONE", 9}, {"OCTAHEDRAL", 4}}}};
  EXPECT_EQ(filters, expected.at(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Gltf, AsToolsMakeThem,
                         ::testing::Values("spot.glb", "spot_khr.glb", "spot_fallback.gltf", "robot.glb", "rover.glb"),
                         [](const auto& info) { return std::to_string(info.index); });

}  // namespace
}  // namespace foredraw::compression_test
