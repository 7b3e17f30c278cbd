// What goes out compressed is taken apart and put together by kind before, and filters are found that lose nothing.
#include <foredraw/io/gltf/codecs/private/meshopt.h>
#include <foredraw/scene/coded_values.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "framework/io/gltf/compressed_scenes.h"
#include "support/meshes.h"

namespace foredraw::gather_views_test {
namespace {

using gltf::before_filter;
using gltf::Coding;
using testing::Bytes;
using testing::expect_same;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::Written;
using Filter = Coding::Filter;

template <class T>
Bytes bytes(const std::vector<T>& values) {
  const auto all = std::as_bytes(std::span(values));
  return {all.begin(), all.end()};
}

Bytes filtered(Bytes rows, Filter filter, std::size_t stride) {
  gltf::apply_filter({Coding::Mode::attributes, filter, rows.size() / stride, stride}, rows);
  return rows;
}

/// How many views of the file have each filter.
std::map<std::string, int> filters(const GltfJson& json, const char* name = "EXT_meshopt_compression") {
  std::map<std::string, int> found;
  for (const GltfJson& view : json["bufferViews"]) {
    if (view.contains("extensions")) ++found[view["extensions"][name].value("filter", "NONE")];
  }
  return found;
}

/// Positions and normals interleaved, 32 bytes a vertex, in a ribbon's place; what lies between is no attribute's.
GltfBuilder interleaved() {
  GltfBuilder builder = testing::ribbon(40);
  std::vector<float> rows;
  for (int v = 0; v < 82; ++v) {
    const float x = static_cast<float>(v / 2) * .125f, y = static_cast<float>(v % 2);
    rows.insert(rows.end(), {x, y, 0, 0, .6f, .8f, 77, 78});
  }
  const std::size_t view = builder.add_view(std::as_bytes(std::span(rows)), 32);
  GltfJson& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["POSITION"] = builder.add_accessor(view, 0, 5126, "VEC3", 82);
  attributes["NORMAL"] = builder.add_accessor(view, 12, 5126, "VEC3", 82);
  GltfJson& position = builder.json["accessors"][attributes["POSITION"].get<std::size_t>()];
  position["min"] = {0, 0, 0};
  position["max"] = {5, 1, 0};
  return builder;
}

TEST(GatherViews, interleaved_attributes_get_views_of_their_own) {
  const Scene scene = testing::read(interleaved());
  const Written written = testing::encode(scene, Compression::ext);
  expect_same(testing::read(written.files[0].bytes), scene, true);
  const GltfJson& attributes = written.json["meshes"][0]["primitives"][0]["attributes"];
  std::set<std::size_t> views;
  for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0"}) {
    const GltfJson& accessor = written.json["accessors"][attributes[name].get<std::size_t>()];
    views.insert(accessor["bufferView"].get<std::size_t>());
    EXPECT_EQ(written.json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteStride"],
              name == std::string("TEXCOORD_0") ? 8 : 12);
  }
  EXPECT_EQ(views.size(), 3u);
}

TEST(GatherViews, meshes_of_one_kind_share_views_and_one_mesh_twice_is_one) {
  GltfBuilder builder = testing::ribbon(40);
  const GltfJson primitive = builder.json["meshes"][0]["primitives"][0];
  builder.add_mesh(primitive);  // the same accessors
  GltfJson other = primitive;
  for (const char* name : {"POSITION", "TEXCOORD_0"}) {  // the same bytes elsewhere
    const GltfJson accessor = builder.json["accessors"][primitive["attributes"][name].get<std::size_t>()];
    const GltfJson view = builder.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const auto first = builder.buffer.begin() + view.value("byteOffset", std::ptrdiff_t{0});
    const Bytes copy(first, first + view["byteLength"].get<std::ptrdiff_t>());
    GltfJson made = accessor;
    made["bufferView"] = builder.add_view(copy);
    other["attributes"][name] = builder.add("accessors", made);
  }
  builder.add_mesh(other);
  const Scene scene = testing::read(builder);
  const Written written = testing::encode(scene, Compression::khr);
  expect_same(testing::read(written.files[0].bytes), scene, true);
  EXPECT_EQ(written.json["bufferViews"].size(), 3u) << "positions, texture coordinates, indices";
  const GltfJson& position =
      written.json["bufferViews"]
                  [written.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()]["bufferView"]
                       .get<std::size_t>()];
  EXPECT_EQ(position["byteLength"], 2 * 82 * 12);
}

TEST(GatherViews, images_and_sparse_accessors_stay) {
  const Scene scene = testing::read(testing::puppet());
  const Written written = testing::encode(scene, Compression::ext);
  expect_same(testing::read(written.files[0].bytes), scene, true);
  EXPECT_EQ(testing::write(testing::read(written.files[0].bytes)), written.files[0].bytes);
}

TEST(LeftOutAccessors, those_that_nothing_names_are_gone_and_the_others_move_up) {
  GltfBuilder builder = testing::puppet();
  builder.add_values(std::vector<float>(30, 1), "VEC3");
  builder.json["accessors"].insert(builder.json["accessors"].begin(), builder.json["accessors"].back());
  const auto moved = [](GltfJson& number) { number = number.get<std::size_t>() + 1; };
  for (GltfJson& primitive : builder.json["meshes"][0]["primitives"]) {
    if (primitive.contains("indices")) moved(primitive["indices"]);
    for (GltfJson& number : primitive["attributes"]) moved(number);
    for (GltfJson& target : primitive["targets"]) {
      for (GltfJson& number : target) moved(number);
    }
  }
  for (GltfJson& skin : builder.json["skins"]) moved(skin["inverseBindMatrices"]);
  for (GltfJson& animation : builder.json["animations"]) {
    for (GltfJson& sampler : animation["samplers"]) {
      moved(sampler["input"]);
      moved(sampler["output"]);
    }
  }
  const std::size_t were = builder.json["accessors"].size();
  const Scene scene = testing::read(builder);
  const Written written = testing::encode(scene, Compression::ext);
  EXPECT_EQ(written.json["accessors"].size(), were - 2);
  const Scene again = testing::read(written.files[0].bytes);
  expect_same(again, scene, true);
  EXPECT_EQ(again.skins[0].inverse_bind_matrices, scene.skins[0].inverse_bind_matrices);
}

TEST(TurnedCorners, lists_of_triangles_alone_may_be_turned) {
  GltfBuilder builder = testing::ribbon(200);
  GltfJson lines = builder.json["meshes"][0]["primitives"][0];
  lines["mode"] = 1;
  lines["indices"] = builder.add_values(std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5}, "SCALAR");
  builder.add_mesh(lines);
  const Scene scene = testing::read(builder);
  Diagnostics diagnostics;
  const auto kept = encode_gltf(scene, "out.glb", diagnostics, {.compression = Compression::ext});
  const auto turned =
      encode_gltf(scene, "out.glb", diagnostics, {.compression = Compression::ext, .turns_corners = true});
  ASSERT_TRUE(kept && turned);
  EXPECT_LT(turned->front().bytes.size(), kept->front().bytes.size());
  expect_same(testing::read(kept->front().bytes), scene, true);
  expect_same(testing::read(turned->front().bytes), scene);
  const Scene again = testing::read(turned->front().bytes);
  EXPECT_EQ(testing::indices_of(again, 1), testing::indices_of(scene, 1)) << "lines";
}

TEST(LosslessFilters, values_that_filters_give_go_through_them) {
  GltfBuilder builder = interleaved();  // positions on a lattice of 1/8
  const Written written = testing::encode(testing::read(builder), Compression::ext);
  EXPECT_GE(filters(written.json)["EXPONENTIAL"], 1);
  std::vector<std::int8_t> normals;
  for (std::int32_t i = 0; i < 82; ++i) {
    const auto direction = direction_of<std::int8_t>({i % 15 - 7, 0, 7});
    normals.insert(normals.end(), {direction[0], direction[1], direction[2], 0});
  }
  GltfBuilder small = testing::ribbon(40);
  const std::size_t view = small.add_view(std::as_bytes(std::span(normals)), 4);
  small.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = small.add_accessor(view, 0, 5120, "VEC3", 82);
  small.json["accessors"].back()["normalized"] = true;
  small.json["extensionsUsed"] = small.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const Scene scene = testing::read(small);
  const Written of_small = testing::encode(scene, Compression::ext);
  EXPECT_EQ(filters(of_small.json)["OCTAHEDRAL"], 1);
  expect_same(testing::read(of_small.files[0].bytes), scene, true);
}

TEST(LosslessFilters, draws_of_several_bits_lie_behind_each_other) {
  std::vector<std::int8_t> normals;
  for (const std::int32_t one : {7, 127, 31}) {
    for (std::int32_t i = -5; i < 5; ++i) {
      const auto direction = direction_of<std::int8_t>({i, i / 2, one});
      normals.insert(normals.end(), {direction[0], direction[1], direction[2], 0});
    }
  }
  const auto rows = before_filter(Filter::octahedral, 4, bytes(normals));
  ASSERT_TRUE(rows);
  EXPECT_EQ(filtered(*rows, Filter::octahedral, 4), bytes(normals));
}

TEST(LosslessFilters, signs_cost_nothing_where_numbers_change_them) {
  std::vector<float> values;
  for (int i = 0; i < 500; ++i) values.push_back(static_cast<float>((i * 37 % 41 - 20) * (i % 7)) * .03125f);
  for (const auto version : {meshopt::VertexVersion::v0, meshopt::VertexVersion::v1}) {
    const auto rows = before_filter(Filter::exponential, 4, bytes(values));
    ASSERT_TRUE(rows);
    const auto raised = gltf::raised_where_shorter(*rows, 4, version);
    EXPECT_NE(raised, *rows);
    EXPECT_EQ(filtered(raised, Filter::exponential, 4), bytes(values));
    EXPECT_LT(meshopt::encode_vertices(raised, 4, version).size(), meshopt::encode_vertices(*rows, 4, version).size());
  }
}

TEST(LosslessFilters, only_components_with_room_are_raised) {
  std::vector<float> values;
  for (int i = 0; i < 500; ++i) {
    const float sign = i % 3 == 0 ? -1.f : 1.f;
    values.insert(values.end(), {sign * (i % 2 == 0 ? 65536.f : 1.f), sign * static_cast<float>(i + 1)});
  }
  const auto rows = before_filter(Filter::exponential, 8, bytes(values));
  ASSERT_TRUE(rows);
  EXPECT_EQ(filtered(gltf::raised_where_shorter(*rows, 8, meshopt::VertexVersion::v1), Filter::exponential, 8),
            bytes(values));
  const auto tiny = before_filter(Filter::exponential, 4, bytes<float>({std::ldexp(-1.f, -95), std::ldexp(1.f, -95)}));
  ASSERT_TRUE(tiny);
  EXPECT_EQ(gltf::raised_where_shorter(*tiny, 4, meshopt::VertexVersion::v0), *tiny)
      << "2^-103 is beyond what decoders know";
  EXPECT_FALSE(before_filter(Filter::exponential, 4, bytes<float>({std::ldexp(1.f, -101)})));
}

TEST(LosslessFilters, what_they_do_not_give_has_no_row) {
  EXPECT_FALSE(before_filter(Filter::octahedral, 4, bytes<std::int8_t>({3, 3, 3, 0})));
  EXPECT_FALSE(before_filter(Filter::octahedral, 8, bytes<std::int16_t>({100, 0, 0, 0})));
  EXPECT_FALSE(before_filter(Filter::octahedral, 12, Bytes(24)));
  EXPECT_FALSE(before_filter(Filter::quaternion, 8, bytes<std::int16_t>({100, 0, 0, 0})));
  EXPECT_FALSE(before_filter(Filter::exponential, 4, bytes<float>({1e20f, 1e-20f})));
  for (const float odd : {-0.0f, std::nanf(""), HUGE_VALF}) {
    EXPECT_FALSE(before_filter(Filter::exponential, 4, bytes<float>({1, odd}))) << odd;
  }
  for (const Filter filter : {Filter::none, Filter::color, Filter::unknown}) {
    EXPECT_FALSE(before_filter(filter, 4, Bytes(16)));
  }
}

RC_GTEST_PROP(LosslessFilters, whatever_has_rows_comes_out_again,
              (std::vector<std::uint32_t> words, std::uint8_t keep)) {
  for (std::uint32_t& word : words) word &= keep % 2 == 0 ? 0xff000000 : 0xffffffff;
  words.resize(words.size() / 2 * 2 + 2);
  for (const Filter filter : {Filter::octahedral, Filter::quaternion, Filter::exponential}) {
    for (const std::size_t stride : {4u, 8u}) {
      const auto rows = before_filter(filter, stride, bytes(words));
      if (rows) RC_ASSERT(filtered(*rows, filter, stride) == bytes(words));
    }
  }
}

}  // namespace
}  // namespace foredraw::gather_views_test
