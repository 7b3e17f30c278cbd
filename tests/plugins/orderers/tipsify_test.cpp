#include "plugins/orderers/tipsify/tipsify.h"

#include "support/meshes.h"
#include "tipsify_reference.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>

namespace foredraw::tipsify_test {
namespace {

using testing::TestMesh;

std::vector<std::uint32_t> reordered(const TestMesh& mesh, const TipsifyOptions& options = {}) {
  IndexStream stream;
  stream.indices = Shared<std::uint32_t>(mesh.indices);
  stream = with_triangle_order(stream, tipsify(mesh.indices, mesh.positions.size(), options));
  return {stream.indices.view().begin(), stream.indices.view().end()};
}

double acmr(std::span<const std::uint32_t> indices, std::size_t vertices, int cache_size) {
  const CacheCount count = count_fifo(indices, vertices, cache_size);
  return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
}

std::vector<std::uint32_t> in_order(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t t : order)
    result.insert(result.end(), {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
  return result;
}

/// Triangles around vertex 0.
TestMesh fan(std::uint32_t triangles) {
  TestMesh mesh{std::vector<glm::vec3>(triangles + 2), {}};
  for (std::uint32_t i = 1; i <= triangles; ++i) mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  return mesh;
}

/// The paper's claim: near 0.6 to 0.7 misses per triangle on regular meshes, in whichever order they come.
TEST(Tipsify, ReachesThePapersAcmrOnRegularMeshes) {
  for (const TestMesh& mesh : {testing::grid(100, 100), testing::sphere(120, 80), testing::torus(120, 60)}) {
    const TestMesh random = testing::shuffled(mesh, 7);
    EXPECT_GT(acmr(random.indices, random.positions.size(), 16), 2.5);
    EXPECT_LT(acmr(reordered(random), random.positions.size(), 16), 0.72);
    EXPECT_LT(acmr(reordered(mesh), mesh.positions.size(), 16), 0.72);
  }
}

/// The same algorithm elsewhere: as good within a hundredth of a miss per triangle.
TEST(Tipsify, IsAsGoodAsThePeer) {
  for (const TestMesh& mesh : {testing::shuffled(testing::grid(150, 90), 3), testing::torus(200, 90)}) {
    for (int cache_size : {12, 16, 24, 32}) {
      std::vector<unsigned> peer(mesh.indices.size());
      meshopt_optimizeVertexCacheFifo(peer.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.size(),
                                      static_cast<unsigned>(cache_size));
      EXPECT_LT(acmr(reordered(mesh, {.cache_size = cache_size}), mesh.positions.size(), cache_size),
                acmr(peer, mesh.positions.size(), cache_size) + 0.01);
    }
  }
}

/// Larger caches are made use of.
TEST(Tipsify, OrdersForItsCacheSize) {
  const TestMesh mesh = testing::shuffled(testing::grid(100, 100), 1);
  const auto small = reordered(mesh, {.cache_size = 12});
  const auto large = reordered(mesh, {.cache_size = 48});
  EXPECT_LT(acmr(small, mesh.positions.size(), 12), acmr(large, mesh.positions.size(), 12));
  EXPECT_LT(acmr(large, mesh.positions.size(), 48), acmr(small, mesh.positions.size(), 48));
}

/// The answer of the paper's algorithm, as an order and as indices.
void expect_the_papers_answer(std::span<const std::uint32_t> indices, std::size_t vertices, int cache_size) {
  const auto order = testing::tipsify_reference(indices, vertices, static_cast<std::uint32_t>(cache_size));
  EXPECT_EQ(tipsify(indices, vertices, {.cache_size = cache_size}), order);
  EXPECT_EQ(tipsify_indices(indices, vertices, {.cache_size = cache_size}), in_order(indices, order));
}

TEST(Tipsify, AnswersAsThePaperDoes) {
  for (const TestMesh& mesh :
       {testing::grid(60, 40), testing::shuffled(testing::torus(80, 50), 4), testing::soup(50, 1)}) {
    for (const int cache_size : {3, 8, 16, 64}) {
      expect_the_papers_answer(mesh.indices, mesh.positions.size(), cache_size);
    }
  }
}

/// A vertex's count of triangles has eight bits where that is enough, or else 32; its time has 24, or else 32.
TEST(Tipsify, AnswersAsThePaperDoesWhereCountsAndTimesAreLarge) {
  for (const std::uint32_t triangles : {254u, 255u, 256u, 300u, 1000u}) {
    const TestMesh mesh = testing::shuffled(testing::joined(fan(triangles), testing::grid(9, 9)), 2);
    expect_the_papers_answer(mesh.indices, mesh.positions.size(), 16);
  }
  const TestMesh mesh = testing::grid(30, 20);
  for (const int cache_size : {(1 << 24) - 3604, (1 << 24) - 3603, (1 << 24) - 3602, 1 << 30}) {
    expect_the_papers_answer(mesh.indices, mesh.positions.size(), cache_size);
  }
}

/// Few vertices make what meshes seldom have: repeated corners, repeated triangles, fans larger than the cache.
RC_GTEST_PROP(Tipsify, AnswersAsThePaperDoesToAnyTriangles, ()) {
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 12);
  auto indices = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices));
  indices.resize(indices.size() / 3 * 3);
  const auto cache_size = *rc::gen::inRange(3, 20);
  const auto order = testing::tipsify_reference(indices, vertices, static_cast<std::uint32_t>(cache_size));
  RC_ASSERT(tipsify(indices, vertices, {.cache_size = cache_size}) == order);
  RC_ASSERT(tipsify_indices(indices, vertices, {.cache_size = cache_size}) == in_order(indices, order));
}

/// Many triangles that hang together by chance: dead ends whose way back leads over other dead ends.
RC_GTEST_PROP(Tipsify, FindsTheSameWayBack, ()) {
  const auto vertices = *rc::gen::inRange<std::uint32_t>(50, 200);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<std::uint32_t> indices(900);
  for (std::uint32_t& v : indices) v = static_cast<std::uint32_t>(random.below(vertices));
  const auto order = testing::tipsify_reference(indices, vertices, 16);
  RC_ASSERT(tipsify(indices, vertices) == order);
  RC_ASSERT(tipsify_indices(indices, vertices) == in_order(indices, order));
}

TEST(Tipsify, HasNothingToDoWithoutTriangles) {
  EXPECT_TRUE(tipsify({}, 0).empty());
  EXPECT_TRUE(tipsify({}, 7).empty());
  EXPECT_TRUE(tipsify_indices({}, 7).empty());
  const std::vector<std::uint32_t> one{2, 0, 1};
  EXPECT_EQ(tipsify_indices(one, 3), one);
}

TEST(Tipsify, MissesThreeTimesATriangleWhereNoneIsShared) {
  const TestMesh mesh = testing::soup(1000, 3);
  EXPECT_EQ(acmr(tipsify_indices(mesh.indices, mesh.positions.size()), mesh.positions.size(), 16), 3);
}

TEST(Tipsify, KeepsEveryCopyOfATriangle) {
  std::vector<std::uint32_t> indices;
  for (int i = 0; i < 500; ++i) indices.insert(indices.end(), {0, 1, 2, 3, 3, 1, 4, 4, 4});
  EXPECT_TRUE(is_permutation(tipsify(indices, 5), indices.size() / 3));
  EXPECT_EQ(tipsify_indices(indices, 5), in_order(indices, tipsify(indices, 5)));
}

/// A million triangles around one vertex, and as many dead ends: the square of them would take hours.
TEST(Tipsify, TakesLinearTime) {
  for (const TestMesh& mesh : {fan(1'000'000), testing::shuffled(fan(1'000'000), 1), testing::soup(1'000'000, 1)}) {
    EXPECT_TRUE(is_permutation(tipsify(mesh.indices, mesh.positions.size()), mesh.indices.size() / 3));
  }
}

/// Numbers of vertices have 31 bits, times 32: what does not fit stays in its own order, and no memory is asked for.
TEST(Tipsify, LeavesWhatItCanNotCount) {
  constexpr std::uint64_t two_31 = std::uint64_t{1} << 31;
  constexpr std::uint64_t two_32 = std::uint64_t{1} << 32;
  EXPECT_TRUE(tipsify_takes(0, two_31 - 1));
  EXPECT_FALSE(tipsify_takes(0, two_31));
  EXPECT_TRUE(tipsify_takes(two_32 - 20, 3));
  EXPECT_FALSE(tipsify_takes(two_32 - 19, 3));
  EXPECT_FALSE(tipsify_takes(two_32 - 20, 3, {.built_for = 17}));
  EXPECT_TRUE(tipsify_takes(3, 3, {.cache_size = std::numeric_limits<int>::max()}));
  const std::vector<std::uint32_t> indices{3, 4, 5, 0, 1, 2};
  std::vector<std::uint32_t> order(2);
  std::vector<std::uint32_t> ordered(6);
  tipsify(order, indices, two_31, {}, *std::pmr::null_memory_resource());
  tipsify_indices(ordered, indices, two_31, {}, *std::pmr::null_memory_resource());
  EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(ordered, indices);
}

/// Fans for a cache two entries larger: fewer misses in the one that is there.
TEST(Tipsify, IsBuiltForALargerCacheWhereToldSo) {
  for (const TestMesh& mesh : {testing::grid(100, 100), testing::shuffled(testing::torus(120, 60), 5)}) {
    const std::size_t vertices = mesh.positions.size();
    const auto larger = tipsify_indices(mesh.indices, vertices, {.built_for = 18});
    EXPECT_EQ(larger, tipsify_indices(mesh.indices, vertices, {.cache_size = 18}));
    EXPECT_LT(acmr(larger, vertices, 16), 0.99 * acmr(tipsify_indices(mesh.indices, vertices), vertices, 16));
  }
}

RC_GTEST_PROP(Tipsify, AnswersWithAPermutationOfAnyTriangles, ()) {
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 40);
  auto indices = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices));
  indices.resize(indices.size() / 3 * 3);
  const auto cache_size = *rc::gen::inRange(3, 40);
  RC_ASSERT(is_permutation(tipsify(indices, vertices, {.cache_size = cache_size}), indices.size() / 3));
}

TEST(Tipsify, WorksInLentMemory) {
  const TestMesh mesh = testing::torus(40, 20);
  // The largest fan has six corners; dead ends are few.
  const std::size_t triangles = mesh.indices.size() / 3;
  std::vector<std::byte> buffer(48 * triangles + 8 * mesh.positions.size() + 12 * 6 + 500);
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size(), std::pmr::null_memory_resource());
  std::vector<std::uint32_t> order(mesh.indices.size() / 3);
  tipsify(order, mesh.indices, mesh.positions.size(), {}, memory);
  EXPECT_EQ(order, tipsify(mesh.indices, mesh.positions.size()));

  std::vector<std::byte> smaller(24 * triangles + 8 * mesh.positions.size() + 8 * 6 + 500);
  std::pmr::monotonic_buffer_resource less(smaller.data(), smaller.size(), std::pmr::null_memory_resource());
  std::vector<std::uint32_t> ordered(mesh.indices.size());
  tipsify_indices(ordered, mesh.indices, mesh.positions.size(), {}, less);
  EXPECT_EQ(ordered, in_order(mesh.indices, order));
}

std::span<const float> floats(std::span<const glm::vec3> positions) { return {&positions[0].x, 3 * positions.size()}; }

void one_by_one(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = count; i-- > 0;) task(i);
}

TEST(TipsifyParts, AnswersAlikeWhoeverDoesThem) {
  const Executor executor(2);
  const auto at_once = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    executor.for_each(count, task);
  };
  const TestMesh mesh = testing::shuffled(testing::torus(300, 150), 4);
  for (const int parts : {2, 3, 5, 64}) {
    const auto order = tipsify_parts(mesh.indices, floats(mesh.positions), parts, {}, one_by_one);
    EXPECT_TRUE(is_permutation(order, mesh.indices.size() / 3));
    EXPECT_EQ(order, tipsify_parts(mesh.indices, floats(mesh.positions), parts, {}, at_once));
    EXPECT_EQ(tipsify_parts_indices(mesh.indices, floats(mesh.positions), parts, {}, at_once),
              in_order(mesh.indices, order));
  }
}

/// Where parts meet, vertices miss the cache once more: little, for they meet along an even line.
TEST(TipsifyParts, CostLittle) {
  for (const TestMesh& mesh : {testing::torus(500, 200), testing::shuffled(testing::torus(500, 200), 4)}) {
    const double whole = acmr(tipsify_indices(mesh.indices, mesh.positions.size()), mesh.positions.size(), 16);
    const auto cost = [&](int parts) {
      const auto ordered = tipsify_parts_indices(mesh.indices, floats(mesh.positions), parts, {}, one_by_one);
      return acmr(ordered, mesh.positions.size(), 16) / whole;
    };
    EXPECT_LT(cost(2), 1.01);
    EXPECT_LT(cost(8), 1.05);
  }
}

/// The plugin cuts where the draw's positions say, on the run's own threads.
TEST(TipsifyParts, AreMadeByThePlugin) {
  const TestMesh mesh = testing::shuffled(testing::torus(300, 150), 4);
  const Scene scene = testing::scene_of(mesh);
  testing::RunFixture fixture;
  const Technique technique = tipsify_plugin().create({{"parts", std::int64_t{3}}, {"built-for", std::int64_t{18}}});
  EXPECT_EQ(std::get<std::unique_ptr<DrawOrderer>>(technique)->order({scene, 0}, fixture.run),
            tipsify_parts(mesh.indices, floats(mesh.positions), 3, {.built_for = 18}, one_by_one));
  EXPECT_FALSE(fixture.run.keeps());
}

TEST(TipsifyParts, AreNotMadeOfSmallDraws) {
  const TestMesh mesh = testing::grid(90, 100);
  const auto refuse = [](std::size_t, const std::function<void(std::size_t)>&) { FAIL(); };
  EXPECT_EQ(tipsify_parts(mesh.indices, floats(mesh.positions), 8, {}, refuse),
            tipsify(mesh.indices, mesh.positions.size()));
}

/// Positions say where to cut and nothing else: whatever they are, all triangles come out.
TEST(TipsifyParts, TakeAnyPositions) {
  const TestMesh mesh = testing::grid(150, 150);
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr float largest = std::numeric_limits<float>::max();
  for (const float odd : {0.f, std::numeric_limits<float>::quiet_NaN(), infinite, -infinite, largest, -largest}) {
    std::vector<glm::vec3> positions = mesh.positions;
    for (std::size_t v = 0; v < positions.size(); v += 7) positions[v] = glm::vec3(odd, -odd, 1);
    EXPECT_TRUE(
        is_permutation(tipsify_parts(mesh.indices, floats(positions), 4, {}, one_by_one), mesh.indices.size() / 3));
  }
  const std::vector<glm::vec3> nowhere(mesh.positions.size());
  EXPECT_TRUE(is_permutation(tipsify_parts(mesh.indices, floats(nowhere), 4, {}, one_by_one), mesh.indices.size() / 3));
}

}  // namespace
}  // namespace foredraw::tipsify_test
