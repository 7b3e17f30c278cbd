#include <foredraw/analysis/vertex_cache.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <deque>
#include <set>

namespace foredraw::analysis_vertex_cache_test {
namespace {

using Indices = std::vector<std::uint32_t>;

/// The cache as a plain queue, newest first.
std::uint64_t misses_by_queue(const Indices& indices, std::size_t size, bool least_recently_used) {
  std::deque<std::uint32_t> queue;
  std::uint64_t misses = 0;
  for (const std::uint32_t vertex : indices) {
    const auto at = std::find(queue.begin(), queue.end(), vertex);
    if (at == queue.end()) {
      ++misses;
    } else if (!least_recently_used) {
      continue;
    } else {
      queue.erase(at);
    }
    queue.push_front(vertex);
    if (queue.size() > size) queue.pop_back();
  }
  return misses;
}

Indices random_triangles(std::uint32_t vertices) {
  auto indices = *rc::gen::scale(10, rc::gen::container<Indices>(rc::gen::inRange<std::uint32_t>(0, vertices)));
  indices.resize(indices.size() / 3 * 3);
  return indices;
}

RC_GTEST_PROP(VertexCacheModels, fifo_is_a_queue, ()) {
  const Indices indices = random_triangles(40);
  const auto size = *rc::gen::inRange(1u, 30u);
  const CacheCount count = count_fifo(indices, 40, size);
  RC_ASSERT(count.misses == misses_by_queue(indices, size, false));
  RC_ASSERT(count.triangles == indices.size() / 3);
  RC_ASSERT(count.referenced == std::set<std::uint32_t>(indices.begin(), indices.end()).size());
}

RC_GTEST_PROP(VertexCacheModels, lru_is_a_queue_that_hits_renew, ()) {
  const Indices indices = random_triangles(40);
  const auto size = *rc::gen::inRange(1u, 30u);
  RC_ASSERT(count_lru(indices, 40, size).misses == misses_by_queue(indices, size, true));
}

TEST(VertexCacheModels, a_cache_that_holds_all_misses_each_vertex_once) {
  const auto mesh = testing::shuffled(testing::torus(30, 20), 3);
  for (const auto& count :
       {count_fifo(mesh.indices, mesh.positions.size(), 1024), count_lru(mesh.indices, mesh.positions.size(), 1024)}) {
    EXPECT_EQ(count.misses, mesh.positions.size());
    EXPECT_EQ(count.triangles, 1200u);
  }
}

TEST(VertexCacheModels, a_batch_ends_where_its_triangles_are_full) {
  const auto mesh = testing::grid(1, 1);
  EXPECT_EQ(count_batches(mesh.indices, 4, {"any", 16, 0, 2}).misses, 4u);
  EXPECT_EQ(count_batches(mesh.indices, 4, {"any", 16, 0, 1}).misses, 6u);  // nothing is shared
  EXPECT_EQ(count_batches(mesh.indices, 4, {"any", 16, 3, 0}).misses, 6u);  // the fourth vertex has no room
}

TEST(VertexCacheModels, a_fetch_reads_whole_lines) {
  const Indices indices = {0, 1, 2};
  EXPECT_EQ(count_fetches(indices, 3, 16), (FetchCount{64, 48}));
  EXPECT_EQ(count_fetches(indices, 3, 48), (FetchCount{192, 144}));
  const Indices far_apart = {0, 100, 200};
  EXPECT_EQ(count_fetches(far_apart, 201, 16), (FetchCount{192, 48}));
}

}  // namespace
}  // namespace foredraw::analysis_vertex_cache_test
