#include "plugins/processors/weld/weld.h"

#include "support/meshes.h"

#include <foredraw/scene/draw.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace foredraw::weld_test {
namespace {

VertexStream bytes_stream(std::string semantic, const std::vector<std::uint8_t>& values) {
  std::vector<std::byte> bytes;
  for (std::uint8_t v : values) bytes.push_back(std::byte{v});
  return {std::move(semantic), Format{Component::uint8, 1, false, 1}, Shared<std::byte>(std::move(bytes))};
}

VertexStreams streams(const std::vector<std::uint8_t>& values) {
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(values.size());
  vertices.base.push_back(bytes_stream("_VALUE", values));
  return vertices;
}

std::vector<std::uint32_t> all(std::uint32_t count) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t v = 0; v < count; ++v) indices.push_back(v);
  return indices;
}

TEST(Weld, MergesEqualVerticesIntoTheFirst) {
  const auto indices = all(5);
  const std::span<const std::uint32_t> use[] = {indices};
  const Weld result = weld(streams({7, 8, 7, 9, 8}), use);
  EXPECT_EQ(result.destination, (std::vector<std::uint32_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(result.count, 3u);
  EXPECT_EQ(result.merged, 2u);
}

TEST(Weld, ComparesMorphTargetsToo) {
  VertexStreams vertices = streams({7, 7});
  vertices.morph_targets.push_back({bytes_stream("_VALUE", {1, 2})});
  const auto indices = all(2);
  const std::span<const std::uint32_t> use[] = {indices};
  EXPECT_EQ(weld(vertices, use).count, 2u);
}

TEST(Weld, TellsMinusZeroFromZero) {
  const auto vertices = testing::vertex_streams({{0, 0, 0}, {-0.0f, 0, 0}});
  const auto indices = all(2);
  const std::span<const std::uint32_t> use[] = {indices};
  EXPECT_EQ(weld(*vertices, use).count, 2u);
}

TEST(Weld, LeavesOutWhatNoTriangleUsesAndCountsIt) {
  const std::vector<std::uint32_t> indices{0, 3, 3};
  const std::span<const std::uint32_t> use[] = {indices};
  const Weld result = weld(streams({1, 2, 1, 3}), use);
  EXPECT_EQ(result.destination, (std::vector<std::uint32_t>{0, no_vertex, no_vertex, 1}));
  EXPECT_EQ(result.unused, 2u);
  EXPECT_EQ(weld(streams({1, 2, 1, 3}), use, {.keep_unused = true}).count, 3u);
}

RC_GTEST_PROP(Weld, LeavesOneVertexForEachContent, (const std::vector<std::uint8_t>& values)) {
  const auto indices = all(static_cast<std::uint32_t>(values.size()));
  const std::span<const std::uint32_t> use[] = {indices};
  const Weld result = weld(streams(values), use);
  std::map<std::uint8_t, std::uint32_t> first;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const auto [at, is_new] = first.emplace(values[v], static_cast<std::uint32_t>(first.size()));
    RC_ASSERT(result.destination[v] == at->second);
  }
  RC_ASSERT(result.count == first.size());
}

}  // namespace
}  // namespace foredraw::weld_test
