// Files that are asked to go out compressed by Draco: everything comes back to the last bit, in its order, unless
// edgebreaker is asked for; what Draco can not hold or makes longer stays plain.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/io/gltf/compressed_scenes.h"
#include "framework/io/gltf/levelled.h"
#include "support/draco_gltf.h"
#include "support/meshes.h"

namespace foredraw::draco_output_test {
namespace {

using testing::Bytes;
using testing::encode;
using testing::expect_same;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::Indices;
using testing::indices_of;
using testing::puppet;
using testing::ribbon;
using testing::Written;

constexpr const char* extension = "KHR_draco_mesh_compression";

const GltfJson& primitive(const GltfJson& json, std::size_t number = 0) {
  return json["meshes"][0]["primitives"][number];
}

bool is_coded(const GltfJson& primitive) {
  return primitive.contains("extensions") && primitive["extensions"].contains(extension);
}

bool tells(const Written& written, const std::string& code) {
  return std::ranges::any_of(written.diagnostics.all(), [&](const Diagnostic& one) { return one.code == code; });
}

GltfBuilder builder_of_primitive(GltfBuilder builder, const GltfJson& primitive) {
  builder.json["meshes"][0]["primitives"].push_back(primitive);
  return builder;
}

/// With more vertices than indices of 16 bits can name.
GltfBuilder long_ribbon() {
  GltfBuilder made = ribbon(35000);
  Indices indices;
  for (std::uint32_t v = 0; v < 70000; v += 2) indices.insert(indices.end(), {v, v + 2, v + 1, v + 1, v + 2, v + 3});
  made.json["meshes"][0]["primitives"][0]["indices"] = made.add_values(indices, "SCALAR");
  return made;
}

/// What each draw shows, in whichever order: its triangles as the bytes of their corners, each from its least corner.
std::vector<std::vector<std::array<Stamp, 3>>> shown(const Scene& scene) {
  std::vector<std::vector<std::array<Stamp, 3>>> all;
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    const VertexStreams& vertices = *scene.draws[d].levels[0].vertices;
    const auto stamp = [&](std::uint32_t v) {
      std::vector<Stamp> parts;
      for (const VertexStream* one : vertices.all())
        parts.push_back(content_hash(one->bytes.view().subspan(v * one->format.bytes, one->format.bytes)));
      return combine(parts);
    };
    const auto place = [&](std::uint32_t v) {
      const auto bytes = testing::stream(scene, d, "POSITION").bytes.view().subspan(v * std::size_t{12}, 12);
      return content_hash(bytes);
    };
    auto& triangles = all.emplace_back();
    const Indices indices = indices_of(scene, d);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
      if (place(a) == place(b) || place(b) == place(c) || place(c) == place(a)) continue;  // draws nothing
      std::array corners{stamp(a), stamp(b), stamp(c)};
      std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
      triangles.push_back(corners);
    }
    std::ranges::sort(triangles);
  }
  return all;
}

TEST(DracoOutput, comes_back_to_the_last_bit_and_in_its_order) {
  for (const GltfBuilder& plain : {puppet(), ribbon(500), long_ribbon()}) {
    const Scene scene = testing::read(plain);
    const Written written = encode(scene, Compression::draco);
    expect_same(testing::read(written.files[0].bytes), scene, true);
    EXPECT_FALSE(tells(written, "draco-reorders"));
    ASSERT_TRUE(is_coded(primitive(written.json)));
    EXPECT_EQ(written.json["extensionsRequired"], GltfJson({extension}));
    EXPECT_EQ(written.json["extensionsUsed"], GltfJson({extension}));
    EXPECT_LT(written.files[0].bytes.size(), plain.glb().size());
    EXPECT_EQ(encode(testing::read(written.files[0].bytes), Compression::draco).files[0].bytes, written.files[0].bytes);
  }
}

TEST(DracoOutput, libdraco_alone_reads_the_same) {
  const GltfBuilder plain = ribbon(500);
  const Scene scene = testing::read(plain);
  const GltfBuilder made = testing::builder_of(encode(scene, Compression::draco).files[0].bytes);
  const GltfJson& told = primitive(made.json)["extensions"][extension];
  const auto decoded = testing::decoded_by_draco(testing::view_bytes(made, told["bufferView"]));
  EXPECT_EQ(decoded.indices, indices_of(scene, 0));
  for (const char* name : {"POSITION", "TEXCOORD_0"}) {
    const auto want = testing::stream(scene, 0, name).bytes.view();
    EXPECT_TRUE(std::ranges::equal(decoded.attributes.at(told["attributes"][name]), want)) << name;
    EXPECT_FALSE(
        made.json["accessors"][primitive(made.json)["attributes"][name].get<std::size_t>()].contains("bufferView"));
  }
}

TEST(DracoOutput, floats_on_no_lattice_keep_their_bits_and_a_note_says_so) {
  GltfBuilder plain = ribbon(300);
  std::vector<float> odd, normals;
  for (std::uint32_t i = 0; i < 602; ++i) {
    const float values[] = {1e30f, -0.0f, 1e-42f, 0.1f * static_cast<float>(i)};
    odd.push_back(values[i % 4]);
    normals.insert(normals.end(), {0, 0.6f, 0.797f + 1e-6f * static_cast<float>(i)});  // not quite of length 1
  }
  plain.json["meshes"][0]["primitives"][0]["attributes"]["_ODD"] = plain.add_values(odd, "SCALAR");
  plain.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = plain.add_values(normals, "VEC3");
  const Scene scene = testing::read(plain);
  const Written written = encode(scene, Compression::draco);
  ASSERT_TRUE(is_coded(primitive(written.json)));
  expect_same(testing::read(written.files[0].bytes), scene, true);
  EXPECT_TRUE(tells(written, "draco-keeps-floats"));
}

TEST(DracoOutput, primitives_that_share_vertices_are_not_made_longer) {
  GltfBuilder plain = ribbon(400);
  GltfJson second = primitive(plain.json);
  for (std::uint16_t first = 0; first < 20; ++first) {
    second["indices"] = plain.add_values(std::vector<std::uint16_t>{first, 1, 2}, "SCALAR");
    plain = builder_of_primitive(plain, second);
  }
  const Scene scene = testing::read(plain);
  const Written written = encode(scene, Compression::draco);
  EXPECT_FALSE(is_coded(primitive(written.json)));
  EXPECT_FALSE(is_coded(primitive(written.json, 5)));
  EXPECT_FALSE(written.json.contains("extensionsUsed"));
  EXPECT_TRUE(tells(written, "draco-left-plain"));
  expect_same(testing::read(written.files[0].bytes), scene, true);
}

TEST(DracoOutput, equal_primitives_share_a_buffer) {
  GltfBuilder plain = ribbon(400);
  plain = builder_of_primitive(plain, primitive(plain.json));
  const Scene scene = testing::read(plain);
  const Written written = encode(scene, Compression::draco_edgebreaker);
  ASSERT_TRUE(is_coded(primitive(written.json, 1)));
  EXPECT_EQ(primitive(written.json, 0)["extensions"], primitive(written.json, 1)["extensions"]);
  EXPECT_EQ(shown(testing::read(written.files[0].bytes)), shown(scene));
}

TEST(DracoOutput, strips_points_and_triangles_without_indices_stay_plain) {
  for (const int mode : {0, 5, 4}) {
    GltfBuilder plain = ribbon(400);
    GltfJson& only = plain.json["meshes"][0]["primitives"][0];
    only["mode"] = mode;
    if (mode == 4) {
      only.erase("indices");
      std::vector<float> positions(9 * 800, 0);
      for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = static_cast<float>(i % 7);
      only["attributes"] = {{"POSITION", plain.add_values(positions, "VEC3")}};
    }
    const Scene scene = testing::read(plain);
    for (const Compression how : {Compression::draco, Compression::draco_edgebreaker}) {
      const Written written = encode(scene, how);
      EXPECT_FALSE(is_coded(primitive(written.json))) << mode;
      expect_same(testing::read(written.files[0].bytes), scene, true);
    }
  }
}

TEST(DracoOutput, edgebreaker_shows_the_same_in_another_order_and_warns) {
  GltfBuilder plain = ribbon(3000);
  Indices corners = indices_of(testing::read(plain), 0);
  corners.insert(corners.end(), {5, 5, 9, 4, 7, 4});  // no area
  plain.json["meshes"][0]["primitives"][0]["indices"] = plain.add_values(corners, "SCALAR");
  const Scene scene = testing::read(plain);
  const Written in_order = encode(scene, Compression::draco);
  const Written written = encode(scene, Compression::draco_edgebreaker);
  EXPECT_TRUE(tells(written, "draco-reorders"));
  EXPECT_LT(written.files[0].bytes.size(), in_order.files[0].bytes.size());
  Diagnostics diagnostics;
  const auto again = read_gltf(written.files[0].bytes, "test", {}, diagnostics);
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);  // counts and ranges are those of what is there
  EXPECT_EQ(shown(*again), shown(scene));
  EXPECT_EQ(again->draws[0].levels[0].orders[0].triangle_count(), 6000u);
}

TEST(DracoOutput, edgebreaker_leaves_the_order_of_what_needs_it) {
  GltfBuilder morphed = ribbon(3000);
  morphed.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] =
      morphed.add_values(std::vector<float>(3 * 6002, 0.5f), "VEC3");
  const Scene scene = testing::read(morphed);
  const Written written = encode(scene, Compression::draco_edgebreaker);
  EXPECT_TRUE(is_coded(primitive(written.json)));
  expect_same(testing::read(written.files[0].bytes), scene, true);
}

TEST(DracoOutput, levels_are_compressed_as_primitives_are) {
  Scene scene = testing::read(ribbon(3000));
  Level half = scene.draws[0].full();
  Indices indices = indices_of(scene, 0);
  indices.resize(indices.size() / 2);
  half.stream().indices = Shared<std::uint32_t>(Indices(indices));
  half.error = 0.25f;
  scene.draws[0].levels.push_back(half);
  for (const Compression how : {Compression::draco, Compression::draco_edgebreaker}) {
    const Written written = encode(scene, how);
    const GltfJson& level = primitive(written.json)["extensions"][testing::levels_name]["levels"][0];
    ASSERT_TRUE(is_coded(level));
    ASSERT_TRUE(is_coded(primitive(written.json)));
    const Scene again = testing::read(written.files[0].bytes);
    ASSERT_EQ(again.draws[0].levels.size(), 2u);
    EXPECT_EQ(again.draws[0].levels[1].error, 0.25f);
    const auto corners = again.draws[0].levels[1].orders[0].indices.view();
    EXPECT_EQ(Indices(corners.begin(), corners.end()), indices);
    EXPECT_EQ(indices_of(again, 0), indices_of(scene, 0));
  }
}

TEST(DracoOutput, one_vertex_is_no_exception) {
  GltfBuilder plain;
  const std::size_t positions = plain.add_values(std::vector<float>{1, 2, 3}, "VEC3");
  plain.json["accessors"][0]["min"] = plain.json["accessors"][0]["max"] = {1, 2, 3};
  const std::size_t corners = plain.add_values(std::vector<std::uint16_t>(3000, 0), "SCALAR");
  plain.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", corners}});
  const Scene scene = testing::read(plain);
  for (const Compression how : {Compression::draco, Compression::draco_edgebreaker})
    expect_same(testing::read(encode(scene, how).files[0].bytes), scene, true);
}

TEST(DracoOutput, an_unknown_extension_keeps_everything_where_it_is) {
  GltfBuilder plain = ribbon(400);
  plain.json["extensionsUsed"] = {"ACME_views"};
  plain.json["extensions"]["ACME_views"] = {{"view", 1}};
  const Scene scene = testing::read(plain);
  const Written written = encode(scene, Compression::draco);
  EXPECT_TRUE(tells(written, "not-compressed"));
  EXPECT_FALSE(is_coded(primitive(written.json)));
  expect_same(testing::read(written.files[0].bytes), scene, true);
}

TEST(DracoOutput, what_came_by_another_codec_goes_out_by_draco_alone) {
  const Scene scene = testing::read(testing::compressed(ribbon(500), {"KHR_meshopt_compression"}));
  const Written written = encode(scene, Compression::draco);
  EXPECT_EQ(written.json["extensionsUsed"], GltfJson({extension}));
  EXPECT_EQ(written.json["buffers"].size(), 1u);
  expect_same(testing::read(written.files[0].bytes), scene, true);
  const Scene coded = testing::read(testing::draco_compressed(ribbon(500), {.bits = 12}));
  const Written again = encode(coded, Compression::draco);
  EXPECT_FALSE(tells(again, "draco-decompressed"));
  expect_same(testing::read(again.files[0].bytes), coded, true);
}

class DracoCorpus : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(DracoCorpus, comes_back) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(GetParam(), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const Written written = encode(*scene, Compression::draco);
  expect_same(testing::read(written.files[0].bytes), *scene, true);
  EXPECT_LE(written.files[0].bytes.size(), std::filesystem::file_size(GetParam()) + 1000);
  const Written free = encode(*scene, Compression::draco_edgebreaker);
  EXPECT_EQ(shown(testing::read(free.files[0].bytes)), shown(*scene));
}

std::vector<std::filesystem::path> models() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(testing::project_file("benchmarks/corpus"))) {
    if (entry.path().extension() == ".glb") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

INSTANTIATE_TEST_SUITE_P(Gltf, DracoCorpus, ::testing::ValuesIn(models()), [](const auto& info) {
  std::string name = info.param.stem().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace foredraw::draco_output_test
