// FOREDRAW_merge_instances: from a scene to a file and back, and where its bytes lie.

#include "support/merged_scenes.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace foredraw::merge_instances_gltf_test {
namespace {

using namespace testing;

/// How often the bytes are in the file.
std::size_t times_in(const Bytes& file, std::span<const std::byte> bytes) {
  std::size_t times = 0;
  for (auto at = file.begin(); (at = std::search(at, file.end(), bytes.begin(), bytes.end())) != file.end(); ++at)
    ++times;
  return times;
}

std::uint64_t bytes_of_accessor(const GltfJson& json, std::size_t accessor) {
  const GltfJson& one = json["accessors"][accessor];
  return json["bufferViews"][one["bufferView"].get<std::size_t>()].value("byteOffset", std::uint64_t{0}) +
         one.value("byteOffset", std::uint64_t{0});
}

std::size_t stride_of(const GltfJson& json, std::size_t accessor, std::size_t tight) {
  return json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()].value("byteStride", tight);
}

/// The accessors of what is merged are parts of the merged ones, and keep what else they said.
void expect_parts(const Scene& scene, const GltfJson& before, const GltfJson& json) {
  const GltfJson& sets = json["extensions"][merge_instances_extension]["sets"];
  ASSERT_EQ(sets.size(), merged_of(scene).size());
  for (const GltfJson& set : sets) {
    for (const GltfJson& primitive : set["primitives"]) {
      const auto m = primitive["mesh"].get<std::size_t>(), p = primitive["primitive"].get<std::size_t>();
      const auto first = primitive["firstVertex"].get<std::size_t>();
      for (const auto& [semantic, number] : json["meshes"][m]["primitives"][p]["attributes"].items()) {
        const auto own = number.get<std::size_t>(), whole = set["attributes"][semantic].get<std::size_t>();
        const std::size_t tight = merged_sets(scene)[0].vertices->find(semantic)->format.bytes;
        EXPECT_EQ(json["accessors"][own]["bufferView"], json["accessors"][whole]["bufferView"]) << semantic;
        EXPECT_EQ(bytes_of_accessor(json, own), bytes_of_accessor(json, whole) + first * stride_of(json, whole, tight))
            << semantic;
        EXPECT_EQ(stride_of(json, whole, tight) % 4, 0u);
        for (const char* key : {"min", "max", "count", "type", "componentType", "normalized"}) {
          EXPECT_EQ(json["accessors"][own].contains(key), before["accessors"][own].contains(key)) << key;
          if (before["accessors"][own].contains(key)) {
            EXPECT_EQ(json["accessors"][own][key], before["accessors"][own][key]) << key;
          }
        }
      }
    }
  }
}

void expect_each_vertex_once(const Scene& scene, const Bytes& file) {
  for (const MergedInstances& set : merged_of(scene)) {
    const VertexStream& positions = *set.vertices->find("POSITION");
    for (std::uint32_t v = 0; v < set.vertices->count; ++v) {
      EXPECT_EQ(times_in(file, positions.bytes.view().subspan(std::size_t{v} * positions.format.bytes, 12)), 1u) << v;
    }
  }
}

void expect_comes_back(const Scene& scene, const Bytes& file) {
  const Scene again = read(file);
  EXPECT_EQ(merged_of(again), merged_of(scene));
  ASSERT_EQ(again.draws.size(), scene.draws.size());
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    EXPECT_EQ(indices_of(again, d), indices_of(scene, d)) << d;
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp()) << d;
    EXPECT_EQ(again.draws[d].traits.has(traits::extended), scene.draws[d].traits.has(traits::extended)) << d;
  }
  EXPECT_EQ(write(again), file) << "what nobody changed comes out as it was";
}

TEST(GltfMergedInstances, come_back_as_they_were_and_no_vertex_is_written_twice) {
  for (const Lay lay : {Lay::apart, Lay::interleaved, Lay::one_after_the_other}) {
    for (const bool materials : {false, true}) {
      SCOPED_TRACE(static_cast<int>(lay));
      const GltfBuilder builder = yard(lay);
      const Scene scene = merged_yard(read(builder), {.frequencies = {6, 3}, .materials = materials});
      ASSERT_EQ(mistake_in(merged_of(scene)[0]), std::nullopt);
      const Bytes file = write(scene);
      expect_comes_back(scene, file);
      expect_parts(scene, builder.json, json_of(file));
      expect_each_vertex_once(scene, file);
      EXPECT_EQ(json_of(file)["extensionsUsed"], GltfJson::array({"KHR_mesh_quantization", merge_instances_extension}));
      EXPECT_EQ(json_of(file)["extensionsRequired"], GltfJson::array({"KHR_mesh_quantization"}));
      EXPECT_EQ(json_of(file)["nodes"], builder.json["nodes"]);
      EXPECT_EQ(json_of(file)["extensions"][merge_instances_extension]["sets"][0].contains("materials"), materials);
    }
  }
}

TEST(GltfMergedInstances, come_back_from_a_gltf_with_its_buffer) {
  const Scene scene = merged_yard(read(yard()));
  const testing::TestFolder own;
  const std::filesystem::path& folder = own.path();
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, folder / "yard.gltf", diagnostics);
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 2u);
  for (const OutputFile& file : *files) {
    std::ofstream(file.path, std::ios::binary)
        .write(reinterpret_cast<const char*>(file.bytes.data()), static_cast<std::streamsize>(file.bytes.size()));
  }
  const auto again = read_gltf(files->front().path, diagnostics, {.products = built_in_products()});
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_EQ(merged_of(*again), merged_of(scene));
}

TEST(GltfMergedInstances, of_a_scene_that_came_from_no_file_come_back_too) {
  Scene scene = read(yard());
  scene.source.reset();
  for (Draw& draw : scene.draws) draw.origin.reset();
  scene = merged_yard(std::move(scene));
  const Bytes file = write(scene);
  EXPECT_EQ(merged_of(read(file)), merged_of(scene));
  expect_each_vertex_once(scene, file);
}

TEST(GltfMergedInstances, instances_of_one_node_are_told_apart) {
  GltfBuilder builder = yard();
  builder.json["extensionsUsed"].push_back("EXT_mesh_gpu_instancing");
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      builder.add_values(std::vector<float>{0, 0, 1, 0, 0, 2, 0, 0, 3}, "VEC3");
  const Scene scene = merged_yard(read(builder));
  EXPECT_EQ(merged_of(scene)[0].places.view()[2], (MergedPlace{0, 0, 2}));
  expect_comes_back(scene, write(scene));
}

/// Their second and third corners are exchanged.
TEST(GltfMergedInstances, mirrored_instances_come_back) {
  GltfBuilder builder = yard();
  for (const std::size_t n : {1u, 5u, 6u}) builder.json["nodes"][n]["scale"] = {-1, 2, 1};
  const Scene scene = merged_yard(read(builder), {.frequencies = {6, 9}});
  expect_comes_back(scene, write(scene));
}

TEST(GltfMergedInstances, accessors_that_several_primitives_share_are_parts_once) {
  GltfBuilder builder = yard();
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  for (int i = 0; i < 3; ++i) primitives.push_back(GltfJson(primitives[0]));
  const Scene scene = merged_yard(read(builder));
  EXPECT_EQ(merged_of(scene)[0].vertices->count, merged_of(merged_yard(read(yard())))[0].vertices->count);
  const Bytes file = write(scene);
  expect_comes_back(scene, file);
  expect_parts(scene, builder.json, json_of(file));
  expect_each_vertex_once(scene, file);
}

/// Vertices that two sets draw from are theirs together, or each has them all: an accessor can be a part of one only.
TEST(GltfMergedInstances, two_sets_of_one_buffer_share_its_accessors) {
  const Scene base = read(yard());
  std::vector<MergedPlace> even, odd;
  for (const MergedPlace& place : all_places(base)) (place.node % 2 == 0 ? even : odd).push_back(place);
  MergedInstances a = merged_by_hand(base, even), b = merged_by_hand(base, odd);
  ASSERT_EQ(a.meshes, b.meshes);
  b.vertices = a.vertices;
  const Scene scene = with_merged(base, {a, b});
  const Bytes file = write(scene);
  expect_comes_back(scene, file);
  const GltfJson json = json_of(file)["extensions"][merge_instances_extension]["sets"];
  EXPECT_EQ(json[0]["attributes"], json[1]["attributes"]);
  expect_each_vertex_once(scene, file);
  const Scene again = read(file);
  EXPECT_EQ(merged_of(again)[0].vertices, merged_of(again)[1].vertices);
}

/// The one set's vertices are those of one mesh, whose accessors are new; the other set has them too, among others.
TEST(GltfMergedInstances, merged_vertices_may_be_a_part_of_other_merged_ones) {
  GltfBuilder builder = yard();
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  primitives.push_back(GltfJson(primitives[0]));
  Scene base = read(builder);
  VertexStream moved = stream(base, 0, "POSITION");
  std::vector<std::byte> bytes(moved.bytes.view().begin(), moved.bytes.view().end());
  bytes[1] ^= std::byte{7};
  moved.bytes = Shared(std::move(bytes));
  base.draws[1].levels[0].vertices = std::make_shared<const VertexStreams>(with_stream(base, 1, moved));
  std::vector<MergedPlace> one{{0, 1, 0}}, others = all_places(base);
  std::erase(others, one[0]);
  for (const bool turned : {false, true}) {
    MergedInstances a = merged_by_hand(base, one), b = merged_by_hand(base, others);
    if (turned) std::swap(a, b);
    const Scene scene = with_merged(base, {a, b});
    const Bytes file = write(scene);
    expect_comes_back(scene, file);
    EXPECT_EQ(times_in(file, stream(base, 1, "POSITION").bytes.view()), 1u);
  }
}

TEST(GltfMergedInstances, sparse_accessors_become_plain_parts) {
  GltfBuilder builder = yard();
  const auto position = builder.json["meshes"][1]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
  const std::size_t places =
      builder.add_view(std::as_bytes(std::span<const std::uint16_t>(std::array<std::uint16_t, 1>{2})));
  const std::size_t moved =
      builder.add_view(std::as_bytes(std::span<const float>(std::array<float, 3>{0.25f, 0.5f, 0.75f})));
  builder.json["accessors"][position]["sparse"] = {{"count", 1},
                                                   {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                                                   {"values", {{"bufferView", moved}}}};
  const Scene scene = merged_yard(read(builder));
  const Bytes file = write(scene);
  expect_comes_back(scene, file);
  expect_parts(scene, builder.json, json_of(file));
  EXPECT_FALSE(json_of(file)["accessors"][position].contains("sparse"));
}

TEST(GltfMergedInstances, come_through_compressed_files) {
  const GltfBuilder plain = yard();
  for (const auto where : {CompressionChoice::Plain::none, CompressionChoice::Plain::data_uri}) {
    CompressionChoice choice;
    choice.plain = where;
    const Scene scene = merged_yard(read(compressed(plain, choice)));
    Diagnostics diagnostics;
    for (const Compression compression : {Compression::keep, Compression::none}) {
      const auto files = encode_gltf(scene, "out.glb", diagnostics, {.compression = compression});
      ASSERT_TRUE(files) << to_text(diagnostics);
      const GltfJson json = json_of(files->front().bytes);
      const auto whole =
          json["extensions"][merge_instances_extension]["sets"][0]["attributes"]["POSITION"].get<std::size_t>();
      const auto view = json["accessors"][whole]["bufferView"].get<std::size_t>();
      EXPECT_EQ(json["bufferViews"][view].contains("extensions"), compression == Compression::keep);
      expect_parts(scene, plain.json, json);
      if (files->size() > 1) continue;  // the plain copy is in a file of its own
      EXPECT_EQ(merged_of(read(files->front().bytes)), merged_of(scene));
    }
  }
}

TEST(GltfMergedInstances, with_an_unknown_extension_everything_stays_where_it_was) {
  GltfBuilder builder = yard();
  builder.json["extensionsUsed"].push_back("ACME_secrets");
  builder.json["extensions"]["ACME_secrets"] = {{"bufferView", 1}, {"accessor", 2}};
  const Scene scene = merged_yard(read(builder));
  const Bytes file = write(scene);
  EXPECT_EQ(merged_of(read(file)), merged_of(scene));
  const GltfJson json = json_of(file);
  for (const char* kind : {"accessors", "bufferViews"}) {
    for (std::size_t i = 0; i < builder.json[kind].size(); ++i)
      EXPECT_EQ(json[kind][i], builder.json[kind][i]) << kind << i;
  }
  EXPECT_EQ(json["extensions"]["ACME_secrets"], builder.json["extensions"]["ACME_secrets"]);
  EXPECT_EQ(times_in(file, builder.buffer), 1u);
}

/// Vertices that no triangle uses, and normals, may be anything. They are also where the merged ones are read.
TEST(GltfMergedInstances, vertices_need_not_be_finite) {
  GltfBuilder builder = yard();
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(builder.buffer.data(), &none, 4);
  const Scene scene = merged_yard(read(builder));
  expect_comes_back(scene, write(scene));
}

TEST(GltfMergedInstances, stay_where_another_draw_changes) {
  GltfBuilder builder = yard();
  const std::size_t position = builder.add_values(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
  const std::size_t index = builder.add_values(std::vector<std::uint16_t>{0, 1, 2, 1, 3, 2}, "SCALAR");
  builder.add_mesh({{"attributes", {{"POSITION", position}}}, {"indices", index}});
  Scene base = read(builder);
  std::vector<MergedPlace> places = all_places(base);
  std::erase_if(places, [&](const MergedPlace& place) { return *base.nodes[place.node].mesh == 3; });
  const Scene scene = with_merged(base, {merged_by_hand(base, places)});
  Scene again = read(write(scene));
  EXPECT_FALSE(again.draws[3].traits.has(traits::extended));
  reverse(again.draws[3]);
  reverse_vertices(again, 3);
  const Bytes file = write(again);
  expect_comes_back(again, file);
  EXPECT_EQ(merged_of(again), merged_of(scene));
  expect_each_vertex_once(scene, file);
}

TEST(GltfMergedInstances, are_gone_where_the_scene_has_none_any_more) {
  const Bytes with = write(merged_yard(read(yard())));
  Scene scene = read(with);
  scene.products.erase(MergedDraws::product);
  const Bytes file = write(scene);
  const GltfJson json = json_of(file);
  EXPECT_FALSE(json.contains("extensions"));
  EXPECT_EQ(json["extensionsUsed"], GltfJson::array({"KHR_mesh_quantization"}));
  EXPECT_LT(file.size(), with.size());
  const Scene again = read(file), before = read(yard());
  EXPECT_TRUE(merged_of(again).empty());
  EXPECT_FALSE(again.draws[0].traits.has(traits::extended));
  for (std::size_t d = 0; d < again.draws.size(); ++d) {
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), before.draws[d].levels[0].vertices->stamp());
  }
}

TEST(GltfMergedInstances, further_ones_are_put_beside_those_there_were) {
  Scene base = read(yard());
  const std::vector<MergedPlace> all = all_places(base);
  const std::vector<MergedPlace> some(all.begin(), all.begin() + 3), others(all.begin() + 3, all.end());
  Scene scene = read(write(with_merged(base, {merged_by_hand(base, some)})));
  scene = with_merged(scene, {merged_by_hand(scene, others)});
  const Bytes file = write(scene);
  const Scene again = read(file);
  EXPECT_EQ(merged_of(again), merged_of(scene));
  EXPECT_EQ(merged_places(again), all);
  EXPECT_EQ(json_of(file)["extensionsUsed"], GltfJson::array({"KHR_mesh_quantization", merge_instances_extension}));
}

/// Whoever sorted them for low overdraw draws the same.
TEST(GltfMergedInstances, slots_of_a_draw_may_come_in_any_sequence) {
  Scene scene = merged_yard(read(yard()));
  std::vector<MergedInstances> sets = merged_of(scene);
  std::vector<MergedSlot> slots(sets[0].slots.view().begin(), sets[0].slots.view().end());
  for (const MergedDraw& draw : sets[0].draws) {
    std::reverse(slots.begin() + draw.first_slot, slots.begin() + draw.first_slot + draw.slot_count);
  }
  sets[0].slots = Shared(std::move(slots));
  scene.products.set(MergedDraws{sets});
  EXPECT_EQ(merged_of(read(builder_of(write(scene)))), merged_of(scene));
}

}  // namespace
}  // namespace foredraw::merge_instances_gltf_test
