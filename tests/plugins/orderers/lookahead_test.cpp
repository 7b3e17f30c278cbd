#include "plugins/orderers/lookahead/lookahead.h"

#include "plugins/orderers/tipsify/tipsify.h"
#include "support/meshes.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <rapidcheck/gtest.h>

namespace foredraw {
namespace {

using testing::TestMesh;

std::vector<std::uint32_t> in_order(const TestMesh& mesh, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t t : order) {
    for (int corner = 0; corner < 3; ++corner) indices.push_back(mesh.indices[3 * std::size_t{t} + corner]);
  }
  return indices;
}

std::vector<std::uint32_t> reordered(const TestMesh& mesh, const LookaheadOptions& options = {}) {
  return in_order(mesh, lookahead(mesh.indices, mesh.positions.size(), options));
}

std::vector<std::uint32_t> by_tipsify(const TestMesh& mesh) {
  return in_order(mesh, tipsify(mesh.indices, mesh.positions.size()));
}

double acmr(const CacheCount& count) { return static_cast<double>(count.misses) / static_cast<double>(count.triangles); }

double acmr(const std::vector<std::uint32_t>& indices, const TestMesh& mesh, const BatchModel& cache) {
  return acmr(count_batches(indices, mesh.positions.size(), cache));
}

double mean_acmr(const std::vector<TestMesh>& meshes, const BatchModel& cache, auto ordered) {
  double sum = 0;
  for (const TestMesh& mesh : meshes) sum += acmr(ordered(mesh), mesh, cache);
  return sum / static_cast<double>(meshes.size());
}

std::vector<TestMesh> meshes() {
  return {testing::grid(60, 50), testing::sphere(80, 50), testing::shuffled(testing::torus(90, 40), 3)};
}

constexpr BatchModel fifo16 = {"fifo", 16, 0, 0};

/// What looking ahead is for: fewer misses than tipsify has, the more so the more is tried out.
TEST(Lookahead, MissesLessThanTipsifyTheMoreItTries) {
  const double plain = mean_acmr(meshes(), fifo16, by_tipsify);
  const auto with = [&](LookaheadQuality quality) {
    return mean_acmr(meshes(), fifo16, [&](const TestMesh& mesh) { return reordered(mesh, {.quality = quality}); });
  };
  EXPECT_LT(with(LookaheadQuality::fast), 0.97 * plain);
  EXPECT_LT(with(LookaheadQuality::balanced), 0.95 * plain);
}

/// Nobody knows the cache that will draw it: the order for 16 entries is no worse than tipsify's in any of these.
TEST(Lookahead, IsNoWorseThanTipsifyForOtherCaches) {
  const std::vector<TestMesh> all = meshes();
  std::vector<BatchModel> caches(batch_models.begin(), batch_models.end());
  for (const std::uint32_t size : {12, 20, 24, 32}) caches.push_back({"fifo", size, 0, 0});
  for (const BatchModel& cache : caches) {
    const auto ours = [](const TestMesh& mesh) { return reordered(mesh); };
    EXPECT_LE(mean_acmr(all, cache, ours), mean_acmr(all, cache, by_tipsify)) << cache.name << cache.cache_size;
  }
  double ours = 0, plain = 0;
  for (const TestMesh& mesh : all) {
    ours += acmr(count_lru(reordered(mesh), mesh.positions.size(), 16));
    plain += acmr(count_lru(by_tipsify(mesh), mesh.positions.size(), 16));
  }
  EXPECT_LE(ours, plain);
}

/// An order for one cache is better there than one for all.
TEST(Lookahead, OrdersForItsTarget) {
  const std::vector<TestMesh> all = meshes();
  const auto robust = [](const TestMesh& mesh) { return reordered(mesh); };
  for (const LookaheadOptions& options : {LookaheadOptions{.target = LookaheadTarget::fifo},
                                         LookaheadOptions{.target = LookaheadTarget::fifo, .cache_size = 32},
                                         LookaheadOptions{.target = LookaheadTarget::nvidia},
                                         LookaheadOptions{.target = LookaheadTarget::amd},
                                         LookaheadOptions{.target = LookaheadTarget::intel}}) {
    const BatchModel cache = cache_of(options);
    const auto made = [&](const TestMesh& mesh) { return reordered(mesh, options); };
    EXPECT_LT(mean_acmr(all, cache, made), mean_acmr(all, cache, robust)) << cache.name << cache.cache_size;
    const auto peer = [](const TestMesh& mesh) {
      std::vector<std::uint32_t> indices(mesh.indices.size());
      meshopt_optimizeVertexCache(indices.data(), mesh.indices.data(), indices.size(), mesh.positions.size());
      return indices;
    };
    EXPECT_LT(mean_acmr(all, cache, made), mean_acmr(all, cache, peer)) << cache.name << cache.cache_size;
  }
}

/// A million triangles around one vertex, and a quarter million that share an edge: no step may look at all of them.
TEST(Lookahead, IsLinearInFans) {
  constexpr std::uint32_t triangles = 1000000;
  TestMesh fan;
  for (std::uint32_t t = 1; t <= triangles; ++t) fan.indices.insert(fan.indices.end(), {0, t, t + 1});
  fan.positions.resize(triangles + 2);
  fan = testing::shuffled(std::move(fan), 5);
  const LookaheadOptions fast{.quality = LookaheadQuality::fast};
  EXPECT_LT(acmr(reordered(fan, fast), fan, fifo16), 1.4);
  TestMesh pages;
  for (std::uint32_t t = 0; t < triangles / 4; ++t) pages.indices.insert(pages.indices.end(), {0, 1, t + 2});
  EXPECT_TRUE(is_permutation(lookahead(pages.indices, triangles, fast), triangles / 4));
}

TEST(Lookahead, TakesTrianglesThatShareNothing) {
  TestMesh soup;
  for (std::uint32_t v = 0; v < 300; ++v) soup.indices.push_back(v);
  soup.positions.resize(300);
  EXPECT_DOUBLE_EQ(acmr(reordered(soup), soup, fifo16), 3.0);
  EXPECT_TRUE(lookahead({}, 0).empty());
  EXPECT_TRUE(lookahead({}, 10).empty());
  EXPECT_EQ(lookahead(std::vector<std::uint32_t>{2, 0, 1}, 3), std::vector<std::uint32_t>{0});
}

/// Vertices repeated within a triangle, triangles repeated, few vertices, any options.
RC_GTEST_PROP(Lookahead, AnswersWithAPermutationOfAnyTriangles, ()) {
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 40);
  auto indices = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices));
  indices.resize(indices.size() / 3 * 3);
  const LookaheadOptions options{.candidates = *rc::gen::inRange(0, 8),
                                 .depth = *rc::gen::inRange(0, 12),
                                 .target = static_cast<LookaheadTarget>(*rc::gen::inRange(0, 5)),
                                 .cache_size = *rc::gen::inRange(3, 40)};
  RC_ASSERT(is_permutation(lookahead(indices, vertices, options), indices.size() / 3));
}

TEST(Lookahead, WorksInLentMemory) {
  const TestMesh mesh = testing::torus(120, 60);
  const std::size_t triangles = mesh.indices.size() / 3;
  std::vector<std::byte> buffer(60 * triangles + 16384);
  std::pmr::unsynchronized_pool_resource memory({}, std::pmr::null_memory_resource());
  std::vector<std::uint32_t> order(triangles);
  std::pmr::monotonic_buffer_resource lent(buffer.data(), buffer.size(), std::pmr::null_memory_resource());
  lookahead(order, mesh.indices, mesh.positions.size(), {}, lent);
  EXPECT_EQ(order, lookahead(mesh.indices, mesh.positions.size()));
}

}  // namespace
}  // namespace foredraw
