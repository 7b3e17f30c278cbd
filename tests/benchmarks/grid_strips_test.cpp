// The reference orders of the vertex-cache contest are orders, and as good as arithmetic says.

#include "support/meshes.h"

#include <benchmarks/vertex_order/grid_strips.h>
#include <foredraw/analysis/vertex_cache.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::bench::grid_strips_test {
namespace {

double acmr(std::uint32_t columns, std::uint32_t rows, StripWidth width, std::uint32_t cache_size) {
  const testing::TestMesh grid = testing::grid(columns, rows);
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t t : grid_strips(columns, rows, width)) {
    indices.insert(indices.end(), &grid.indices[3 * t], &grid.indices[3 * t] + 3);
  }
  const CacheCount count = count_fifo(indices, grid.positions.size(), cache_size);
  return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
}

TEST(GridStrips, name_every_triangle_once) {
  for (const auto& [columns, rows] : {std::pair{1u, 1u}, {5u, 3u}, {40u, 4u}, {40u, 40u}, {3u, 40u}}) {
    for (const StripWidth width : {plain_strips(16), primed_strips(16), primed_strips(6)}) {
      std::vector<std::uint32_t> order = grid_strips(columns, rows, width);
      std::ranges::sort(order);
      std::vector<std::uint32_t> all(2 * columns * rows);
      std::iota(all.begin(), all.end(), 0u);
      EXPECT_EQ(order, all) << columns << " x " << rows;
    }
  }
}

// A plain strip of w columns shades w + 1 vertices for each of the rows' vertices, and nothing twice.
TEST(GridStrips, plain_ones_shade_a_vertex_once_a_strip) {
  const double strips = 420 / 7;
  EXPECT_DOUBLE_EQ(acmr(420, 420, plain_strips(16), 16), strips * (7 + 1) * 421 / (2 * 420 * 420));
}

// With all strips primed from outside it would be 33 strips of 13 columns: 453 * 421 / 352800 = .5406. What is above
// that, each strip pays for growing.
TEST(GridStrips, primed_ones_come_near_to_strips_of_all_but_three_entries) {
  for (const std::uint32_t cache_size : {12u, 16u, 24u, 32u}) {
    const std::uint32_t width = cache_size - 3;
    const double strips = (420 + width - 1) / width;
    const double unpaid = (420 + strips) * 421 / (2 * 420 * 420);
    const double reached = acmr(420, 420, primed_strips(cache_size), cache_size);
    EXPECT_GT(reached, unpaid);
    EXPECT_LT(reached, 1.01 * unpaid) << "cache of " << cache_size;
    EXPECT_LT(reached, acmr(420, 420, plain_strips(cache_size), cache_size));
  }
  EXPECT_LT(acmr(420, 420, primed_strips(16), 16), 0.542);
}

// One column more, and the cache loses every vertex just before its last use.
TEST(GridStrips, primed_ones_can_be_no_wider) {
  StripWidth width = primed_strips(16);
  ++width.most;
  EXPECT_GT(acmr(420, 420, width, 16), 1);
}

}  // namespace
}  // namespace foredraw::bench::grid_strips_test
