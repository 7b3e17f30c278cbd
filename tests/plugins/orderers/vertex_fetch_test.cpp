#include "plugins/orderers/vertex_fetch/vertex_fetch.h"

#include "support/meshes.h"

#include <foredraw/analysis/vertex_cache.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::vertex_fetch_test {
namespace {

TEST(VertexFetch, NumbersByFirstUseOverAllStreams) {
  const std::vector<std::uint32_t> a{4, 2, 0}, b{2, 5, 4};
  const std::span<const std::uint32_t> streams[] = {a, b};
  EXPECT_EQ(vertex_fetch(streams, 7), (std::vector<std::uint32_t>{4, 2, 0, 5, 1, 3, 6}));
}

TEST(VertexFetch, OfNoStreamKeepsTheOrder) { EXPECT_EQ(vertex_fetch({}, 3), (std::vector<std::uint32_t>{0, 1, 2})); }

/// Why it is done: vertices in random order are fetched several times over, in order hardly more than once.
TEST(VertexFetch, BringsOverfetchNearToOne) {
  const testing::TestMesh mesh = testing::grid(300, 300);
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  std::vector<std::uint32_t> random(vertices);
  std::iota(random.begin(), random.end(), 0u);
  Random numbers(5);
  for (std::uint32_t i = vertices; i > 1; --i) std::swap(random[i - 1], random[numbers.below(i)]);
  std::vector<std::uint32_t> indices = mesh.indices;
  for (auto& index : indices) index = random[index];

  const std::span<const std::uint32_t> streams[] = {indices};
  const auto order = vertex_fetch(streams, vertices);
  std::vector<std::uint32_t> destination(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) destination[order[v]] = v;
  std::vector<std::uint32_t> fetched = indices;
  for (auto& index : fetched) index = destination[index];

  const auto overfetch = [&](const std::vector<std::uint32_t>& stream) {
    const FetchCount count = count_fetches(stream, vertices, 32);
    return static_cast<double>(count.fetched) / static_cast<double>(count.referenced);
  };
  EXPECT_GT(overfetch(indices), 2.0);
  EXPECT_LT(overfetch(fetched), 1.1);
}

}  // namespace
}  // namespace foredraw::vertex_fetch_test
