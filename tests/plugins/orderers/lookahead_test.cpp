#include "plugins/orderers/lookahead/lookahead.h"

#include "plugins/orderers/lookahead/fan_walk.h"
#include "support/meshes.h"
#include "tipsify_reference.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace foredraw::lookahead_test {
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
  return in_order(mesh, testing::tipsify_reference(mesh.indices, mesh.positions.size(), 16));
}

double acmr(const CacheCount& count) {
  return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
}

double acmr(const std::vector<std::uint32_t>& indices, const TestMesh& mesh, const BatchModel& cache) {
  return acmr(count_batches(indices, mesh.positions.size(), cache));
}

double mean_acmr(const std::vector<TestMesh>& meshes, const BatchModel& cache, auto ordered) {
  double sum = 0;
  for (const TestMesh& mesh : meshes) sum += acmr(ordered(mesh), mesh, cache);
  return sum / static_cast<double>(meshes.size());
}

/// A grid whose squares are cut along either diagonal, as it happens: vertices of 2 to 8 triangles, as models have
/// them.
TestMesh irregular_grid(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
  Random random(seed);
  TestMesh mesh{testing::grid(columns, rows).positions, {}};
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x, b = a + 1, c = b + columns, d = c + 1;
      if (random.below(2) == 0) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
      } else {
        mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
      }
    }
  }
  return mesh;
}

std::vector<TestMesh> meshes() {
  return {irregular_grid(60, 50, 1), testing::shuffled(irregular_grid(90, 40, 2), 3), irregular_grid(40, 80, 4)};
}

constexpr BatchModel fifo16 = {"fifo", 16, 0, 0};

/// What looking ahead is for: fewer misses than tipsify has, the more so the more is tried out.
TEST(Lookahead, MissesLessThanTipsifyTheMoreItTries) {
  const double plain = mean_acmr(meshes(), fifo16, by_tipsify);
  const auto with = [&](LookaheadQuality quality) {
    return mean_acmr(meshes(), fifo16, [&](const TestMesh& mesh) { return reordered(mesh, {.quality = quality}); });
  };
  EXPECT_LT(with(LookaheadQuality::fast), 0.96 * plain);
  EXPECT_LT(with(LookaheadQuality::balanced), 0.91 * plain);
  EXPECT_LT(with(LookaheadQuality::high), with(LookaheadQuality::fast));
}

/// Deeper trials alone find the worse order of some of these.
TEST(Lookahead, HighMissesNoMoreThanBalancedInAnyMesh) {
  for (const LookaheadTarget target : {LookaheadTarget::robust, LookaheadTarget::fifo, LookaheadTarget::amd}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const TestMesh mesh = irregular_grid(10 + 3 * static_cast<std::uint32_t>(seed), 30, seed);
      const auto with = [&](LookaheadQuality quality) {
        const LookaheadOptions options{.quality = quality, .target = target};
        return count_batches(reordered(mesh, options), mesh.positions.size(), cache_of(options)).misses;
      };
      EXPECT_LE(with(LookaheadQuality::high), with(LookaheadQuality::balanced)) << seed;
    }
  }
}

/// Nobody knows the cache that will draw it: the order for 16 entries is no worse than tipsify's in any of these.
class LookaheadAtQuality : public ::testing::TestWithParam<LookaheadQuality> {};

TEST_P(LookaheadAtQuality, IsNoWorseThanTipsifyForOtherCaches) {
  std::vector<std::vector<std::uint32_t>> ours, plain;
  const std::vector<TestMesh> all = meshes();
  for (const TestMesh& mesh : all) {
    ours.push_back(reordered(mesh, {.quality = GetParam()}));
    plain.push_back(by_tipsify(mesh));
  }
  const auto mean = [&](const std::vector<std::vector<std::uint32_t>>& orders, auto count) {
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) sum += acmr(count(orders[i], all[i].positions.size()));
    return sum / static_cast<double>(all.size());
  };
  std::vector<BatchModel> caches(batch_models.begin(), batch_models.end());
  for (const std::uint32_t size : {12, 20, 24, 32}) caches.push_back({"fifo", size, 0, 0});
  for (const BatchModel& cache : caches) {
    const auto count = [&](const auto& indices, std::size_t vertices) {
      return count_batches(indices, vertices, cache);
    };
    EXPECT_LE(mean(ours, count), mean(plain, count)) << cache.name << cache.cache_size;
  }
  const auto lru = [](const auto& indices, std::size_t vertices) { return count_lru(indices, vertices, 16); };
  EXPECT_LE(mean(ours, lru), mean(plain, lru));
}

std::string quality_name(const ::testing::TestParamInfo<LookaheadQuality>& info) {
  return info.param == LookaheadQuality::fast ? "fast" : info.param == LookaheadQuality::balanced ? "balanced" : "high";
}

INSTANTIATE_TEST_SUITE_P(Qualities, LookaheadAtQuality,
                         ::testing::Values(LookaheadQuality::fast, LookaheadQuality::balanced, LookaheadQuality::high),
                         quality_name);

/// On a grid every strip is as wide as every other, and what one of them loses where a batch ends all of them lose:
/// strips that fill the cache to the last entry miss a quarter more there than tipsify's.
TEST(Lookahead, IsNoWorseThanTipsifyOnGridsInBatchesWhereItIsFast) {
  for (const TestMesh& mesh : {testing::grid(120, 120), testing::shuffled(testing::grid(200, 90), 3)}) {
    const auto fast = reordered(mesh, {.quality = LookaheadQuality::fast});
    for (const BatchModel& cache : {batch_models[0], batch_models[1]}) {
      EXPECT_LE(acmr(fast, mesh, cache), acmr(by_tipsify(mesh), mesh, cache)) << cache.name;
    }
  }
}

/// Where nothing in the cache is left there is a choice too, as far as there are vertices, and each is offered once.
TEST(Lookahead, HasSeveralPlacesToBegin) {
  const TestMesh mesh = testing::grid(1, 2);  // six vertices
  std::vector<std::uint32_t> order(4);
  FanWalk walk(order, mesh.indices, mesh.positions.size(), fifo16, {}, *std::pmr::get_default_resource());
  const auto offered = [&](std::size_t most) {
    const auto found = walk.promising(most, 0);
    return std::vector(found.begin(), found.end());
  };
  EXPECT_EQ(offered(1), std::vector<std::uint32_t>({0}));
  EXPECT_EQ(offered(16), std::vector<std::uint32_t>({0, 1, 2, 3, 4, 5}));
  walk.draw(0);
  walk.draw(5);
  walk.draw(2);
  walk.draw(3);
  EXPECT_TRUE(offered(16).empty());
}

/// An order for one cache is better there than one for all.
TEST(Lookahead, OrdersForItsTarget) {
  const std::vector<TestMesh> all = meshes();
  const auto robust = [](const TestMesh& mesh) { return reordered(mesh); };
  for (const LookaheadOptions& options :
       {LookaheadOptions{.target = LookaheadTarget::fifo},
        LookaheadOptions{.target = LookaheadTarget::fifo, .cache_size = 32},
        LookaheadOptions{.target = LookaheadTarget::nvidia}, LookaheadOptions{.target = LookaheadTarget::amd},
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

/// A million triangles around one vertex, fewer of them shuffled, and a quarter million that share an edge: no step may
/// look at all of them.
TEST(Lookahead, IsLinearInFans) {
  const auto fan = [](std::uint32_t triangles) {
    TestMesh mesh;
    for (std::uint32_t t = 1; t <= triangles; ++t) mesh.indices.insert(mesh.indices.end(), {0, t, t + 1});
    mesh.positions.resize(triangles + 2);
    return mesh;
  };
  const LookaheadOptions fast{.quality = LookaheadQuality::fast};
  const TestMesh even = fan(1'000'000), mixed = testing::shuffled(fan(200'000), 5);
  EXPECT_LT(acmr(reordered(even, fast), even, fifo16), 1.1);
  EXPECT_LT(acmr(reordered(mixed, fast), mixed, fifo16), 1.4);
  TestMesh pages;
  for (std::uint32_t t = 0; t < 250'000; ++t) pages.indices.insert(pages.indices.end(), {0, 1, t + 2});
  EXPECT_TRUE(is_permutation(lookahead(pages.indices, 250'002, fast), 250'000));
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

/// One triangle a hundred thousand times, as it is, turned, and without an area.
TEST(Lookahead, KeepsEveryCopyOfATriangle) {
  TestMesh copies;
  for (std::uint32_t t = 0; t < 100'000; ++t) {
    const std::uint32_t a = t % 3, b = t % 5 == 0 ? a : (t + 1) % 3;
    copies.indices.insert(copies.indices.end(), {a, b, (t + 2) % 3});
  }
  copies.positions.resize(3);
  EXPECT_TRUE(is_permutation(lookahead(copies.indices, 3), 100'000));
  EXPECT_EQ(count_fifo(reordered(copies), 3, 16).misses, 3u);
}

/// Its clock has 32 bits, which batches of 30 vertices use up twice as fast as there are indices.
TEST(Lookahead, KnowsWhatItCanNotCount) {
  constexpr std::uint64_t most = 2'000'000'000, two_32 = std::uint64_t{1} << 32;
  EXPECT_TRUE(lookahead_takes(most));
  EXPECT_FALSE(lookahead_takes(most + 1));
  EXPECT_FALSE(lookahead_takes(two_32 + 3));
  EXPECT_LT(most + most / 30 * 32, two_32 - 1024);
}

/// Vertices repeated within a triangle, triangles repeated, few vertices, any options.
RC_GTEST_PROP(Lookahead, AnswersWithAPermutationOfAnyTriangles, ()) {
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 40);
  auto indices = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices));
  indices.resize(indices.size() / 3 * 3);
  const LookaheadOptions options{.quality = static_cast<LookaheadQuality>(*rc::gen::inRange(0, 3)),
                                 .candidates = *rc::gen::inRange(0, 20),
                                 .depth = *rc::gen::inRange(0, 12),
                                 .target = static_cast<LookaheadTarget>(*rc::gen::inRange(0, 5)),
                                 .cache_size = *rc::gen::inRange(3, 40)};
  RC_ASSERT(is_permutation(lookahead(indices, vertices, options), indices.size() / 3));
}

/// Keeps account of the most that was held at once.
class Purse : public std::pmr::memory_resource {
 public:
  std::size_t most = 0;

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    most = std::max(most, held_ += bytes);
    return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t alignment) override {
    held_ -= bytes;
    std::pmr::new_delete_resource()->deallocate(at, bytes, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  std::size_t held_ = 0;
};

TEST(Lookahead, LeavesTheOrderWhereItIsCancelled) {
  const TestMesh mesh = testing::shuffled(testing::grid(20, 20), 5);
  const std::atomic<bool> cancel = true;
  for (const LookaheadQuality quality : {LookaheadQuality::balanced, LookaheadQuality::high}) {
    EXPECT_EQ(reordered(mesh, {.quality = quality, .cancel = &cancel}), mesh.indices);
  }
}

TEST(Lookahead, HoldsSixtyBytesATriangle) {
  const TestMesh mesh = testing::shuffled(testing::torus(150, 90), 2);
  Purse purse;
  std::vector<std::uint32_t> order(mesh.indices.size() / 3);
  lookahead(order, mesh.indices, mesh.positions.size(), {.quality = LookaheadQuality::fast}, purse);
  EXPECT_EQ(order, lookahead(mesh.indices, mesh.positions.size(), {.quality = LookaheadQuality::fast}));
  EXPECT_LE(purse.most, 60 * order.size() + 20'000);

  Purse larger;
  lookahead(order, mesh.indices, mesh.positions.size(), {.quality = LookaheadQuality::high}, larger);
  EXPECT_LE(larger.most, 64 * order.size() + 20'000);
}

}  // namespace
}  // namespace foredraw::lookahead_test
