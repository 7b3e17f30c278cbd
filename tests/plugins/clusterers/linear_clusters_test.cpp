#include "plugins/clusterers/linear_clusters/linear_clusters.h"

#include "support/meshes.h"

#include <foredraw/analysis/vertex_cache.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace foredraw::linear_clusters_test {
namespace {

using testing::TestMesh;

/// Misses per triangle where each cluster starts with an empty cache.
double acmr_of_clusters(const TestMesh& mesh, const Clusters& clusters, int cache_size) {
  std::uint64_t misses = 0;
  for (std::size_t c = 0; c < clusters.count(); ++c) {
    const std::span<const std::uint32_t> part =
        std::span(mesh.indices).subspan(3 * clusters.offsets[c], 3 * (clusters.offsets[c + 1] - clusters.offsets[c]));
    misses += count_fifo(part, mesh.positions.size(), cache_size).misses;
  }
  return static_cast<double>(misses) / static_cast<double>(mesh.indices.size() / 3);
}

TEST(LinearClusters, CutsHardWhereAllThreeVerticesMiss) {
  const TestMesh two = testing::joined(testing::grid(4, 4), testing::grid(4, 4));
  const Clusters clusters = linear_clusters(two.indices, two.positions.size(), 64, {.lambda = 0.5});
  EXPECT_EQ(clusters.offsets, (std::vector<std::uint32_t>{0, 32, 64}));
}

/// Each patch but the last of a hard one ends at the first triangle at which it is down to lambda.
TEST(LinearClusters, ClosesAPatchAsSoonAsItIsDownToLambda) {
  const TestMesh mesh = testing::grid(7, 40);  // narrow: the whole grid is one hard patch for 16 entries
  const double lambda = 0.85;
  const Clusters clusters = linear_clusters(mesh.indices, mesh.positions.size(), 16, {.lambda = lambda});
  ASSERT_GT(clusters.count(), 3u);
  for (std::size_t c = 0; c + 1 < clusters.count(); ++c) {
    const auto part = std::span<const std::uint32_t>(mesh.indices)
                          .subspan(3 * clusters.offsets[c], 3 * (clusters.offsets[c + 1] - clusters.offsets[c]));
    const auto acmr = [&](std::span<const std::uint32_t> triangles) {
      return static_cast<double>(count_fifo(triangles, mesh.positions.size(), 16).misses) / (triangles.size() / 3);
    };
    EXPECT_LE(acmr(part), lambda);
    EXPECT_GT(acmr(part.first(part.size() - 3)), lambda);
  }
}

/// What growth promises: hardly more than that many times the vertex work of the uncut order.
TEST(LinearClusters, KeepsToItsGrowth) {
  const TestMesh mesh = testing::grid(7, 400);
  const double uncut = acmr_of_clusters(mesh, {{0, static_cast<std::uint32_t>(mesh.indices.size() / 3)}}, 16);
  std::size_t fewer = ~std::size_t{0};
  for (double growth : {1.5, 1.2, 1.05}) {
    const Clusters clusters = linear_clusters(mesh.indices, mesh.positions.size(), 16, {.growth = growth});
    EXPECT_LE(acmr_of_clusters(mesh, clusters, 16), growth * uncut);
    EXPECT_LT(clusters.count(), fewer);
    fewer = clusters.count();
  }
}

TEST(LinearClusters, LambdaThreeMakesEachTriangleAPatch) {
  const TestMesh mesh = testing::grid(5, 5);
  EXPECT_EQ(linear_clusters(mesh.indices, mesh.positions.size(), 16, {.lambda = 3}).count(), 50u);
}

RC_GTEST_PROP(LinearClusters, AnswersWithAPartitionOfAnyTriangles, ()) {
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 30);
  auto indices = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices));
  indices.resize(indices.size() / 3 * 3);
  const double lambda = *rc::gen::inRange(50, 301) / 100.0;
  RC_ASSERT(is_partition(linear_clusters(indices, vertices, 16, {.lambda = lambda}), indices.size() / 3));
}

}  // namespace
}  // namespace foredraw::linear_clusters_test
