// Every model of the corpus: untouched it comes out byte for byte, and whatever is changed, the rest stays.
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/scene/vertex_groups.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "support/gltf_builder.h"
#include "support/meshes.h"

namespace foredraw::gltf_corpus_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> models() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(testing::project_file("benchmarks/corpus"))) {
    const fs::path extension = entry.path().extension();
    if (extension == ".glb" || extension == ".gltf") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::byte> file_bytes(const fs::path& path) {
  Diagnostics diagnostics;
  return read_file(path, diagnostics).value();
}

Scene read(const fs::path& path) {
  Diagnostics diagnostics;
  auto scene = read_gltf(path, diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return *scene;
}

/// The scene that was written, read back from the bytes.
Scene written_and_read(const Scene& scene, const fs::path& target) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, target, diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  auto again = read_gltf(files->front().bytes, target.string(), target.parent_path(), diagnostics);
  if (!again) throw std::runtime_error(to_text(diagnostics));
  return *again;
}

/// Each draw's corners as the bytes of all their attributes and targets: what is drawn, whatever the numbers are.
std::vector<std::vector<Stamp>> drawn(const Scene& scene) {
  std::vector<std::vector<Stamp>> result;
  for (const Draw& draw : scene.draws) {
    const Level& level = draw.levels[0];
    std::vector<Stamp> vertices(level.vertices->count);
    for (std::uint32_t v = 0; v < level.vertices->count; ++v) {
      std::vector<Stamp> parts;
      for (const VertexStream* stream : level.vertices->all()) {
        parts.push_back(content_hash(stream->bytes.view().subspan(v * stream->format.bytes, stream->format.bytes)));
      }
      vertices[v] = combine(parts);
    }
    auto& triangles = result.emplace_back();
    const auto indices = level.orders[0].indices.view();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const std::array<Stamp, 3> corners{vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]};
      triangles.push_back(combine(corners));
    }
    std::sort(triangles.begin(), triangles.end());
  }
  return result;
}

class GltfCorpus : public ::testing::TestWithParam<fs::path> {};

TEST_P(GltfCorpus, untouched_is_byte_equal) {
  Diagnostics diagnostics;
  const fs::path target = GetParam().parent_path() / ("out" + GetParam().extension().string());
  const auto files = encode_gltf(read(GetParam()), target, diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  EXPECT_EQ(files->front().bytes, file_bytes(GetParam()));
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
}

TEST_P(GltfCorpus, the_other_container_holds_the_same) {
  const Scene scene = read(GetParam());
  Diagnostics diagnostics;
  const Scene packed = written_and_read(scene, GetParam().parent_path() / "out.glb");
  EXPECT_EQ(drawn(packed), drawn(scene));
  const auto files = encode_gltf(packed, GetParam().parent_path() / "out.gltf", diagnostics);
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ((*files)[1].path, GetParam().parent_path() / "out.bin");
  testing::GltfJson json = testing::json_of(files->front().bytes);
  EXPECT_EQ(json["buffers"][0]["uri"], "out.bin");
  json["buffers"] = testing::json_of(file_bytes(GetParam()))["buffers"];
  EXPECT_EQ(json["meshes"], testing::json_of(file_bytes(GetParam()))["meshes"]);
  EXPECT_EQ(json["nodes"], testing::json_of(file_bytes(GetParam()))["nodes"]);
}

TEST_P(GltfCorpus, reversed_triangles_draw_the_same_and_touch_nothing_else) {
  const Scene scene = read(GetParam());
  Scene changed = scene;
  for (Draw& draw : changed.draws) {
    std::vector<std::uint32_t> order(draw.levels[0].orders[0].triangle_count());
    std::iota(order.rbegin(), order.rend(), 0u);
    if (draw.topology == Topology::triangles) draw = with_triangle_order(draw, order);
  }
  const Scene again = written_and_read(changed, GetParam().parent_path() / "out.glb");
  EXPECT_EQ(drawn(again), drawn(scene));
  ASSERT_EQ(again.draws.size(), changed.draws.size());
  for (std::size_t d = 0; d < again.draws.size(); ++d) {
    EXPECT_EQ(again.draws[d].levels[0].orders[0].indices, changed.draws[d].levels[0].orders[0].indices);
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp());
    EXPECT_EQ(again.draws[d].traits, scene.draws[d].traits);
    EXPECT_EQ(again.draws[d].name, scene.draws[d].name);
  }
  for (std::size_t i = 0; i < scene.images.size(); ++i) EXPECT_EQ(again.images[i].bytes, scene.images[i].bytes);
  EXPECT_EQ(again.animations.size(), scene.animations.size());
}

TEST_P(GltfCorpus, moved_and_dropped_vertices_draw_the_same_and_take_less) {
  const Scene scene = read(GetParam());
  Scene changed = scene;
  for (Draw& draw : changed.draws) {  // the first half of the triangles
    IndexStream& stream = draw.levels[0].orders[0];
    const auto indices = stream.indices.view().first((stream.triangle_count() + 1) / 2 * 3);
    stream.indices = Shared<std::uint32_t>({indices.begin(), indices.end()});
  }
  const std::vector<std::vector<Stamp>> wanted = drawn(changed);
  for (const VertexGroup& group : vertex_groups(changed)) {  // backwards, unused ones left out
    std::vector<std::uint32_t> destination(group.vertices->count, no_vertex);
    for (const auto& indices : index_streams_of(changed, group)) {
      for (std::uint32_t v : indices) destination[v] = 0;
    }
    std::uint32_t count = 0;
    for (auto v = destination.rbegin(); v != destination.rend(); ++v) {
      if (*v != no_vertex) *v = count++;
    }
    move_vertices(changed, group, destination, count);
  }
  const fs::path target = GetParam().parent_path() / "out.glb";
  EXPECT_EQ(drawn(written_and_read(changed, target)), wanted);
  Diagnostics diagnostics;
  EXPECT_LT(encode_gltf(changed, target, diagnostics)->front().bytes.size(),
            encode_gltf(written_and_read(scene, target), target, diagnostics)->front().bytes.size());
}

TEST_P(GltfCorpus, scene_without_its_source_is_written_anew) {
  const Scene scene = read(GetParam());
  Scene bare = scene;
  bare.source.reset();
  const Scene again = written_and_read(bare, GetParam().parent_path() / "out.glb");
  EXPECT_EQ(drawn(again), drawn(scene));
  ASSERT_EQ(again.nodes.size(), scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) EXPECT_EQ(again.nodes[i].local(), scene.nodes[i].local());
  ASSERT_EQ(again.skins.size(), scene.skins.size());
  for (std::size_t i = 0; i < scene.skins.size(); ++i) {
    EXPECT_EQ(again.skins[i].inverse_bind_matrices, scene.skins[i].inverse_bind_matrices);
  }
  ASSERT_EQ(again.animations.size(), scene.animations.size());
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    ASSERT_EQ(again.animations[i].channels.size(), scene.animations[i].channels.size());
    for (std::size_t c = 0; c < scene.animations[i].channels.size(); ++c) {
      EXPECT_EQ(again.animations[i].channels[c].values, scene.animations[i].channels[c].values);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, GltfCorpus, ::testing::ValuesIn(models()), [](const auto& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name + (info.param.extension() == ".glb" ? "_glb" : "_gltf");
});

}  // namespace
}  // namespace foredraw::gltf_corpus_test
