#include <foredraw/overdraw/heat_map.h>

#include "support/painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::heat_map_test {
namespace {

using testing::part_of;
using testing::TestMesh;

/// A square that faces +Z.
TestMesh quad(float z, float half = 1) {
  return {{{-half, -half, z}, {half, -half, z}, {-half, half, z}, {half, half, z}}, {0, 1, 2, 2, 1, 3}};
}

TEST(HeatMap, counts_what_drawing_counts) {
  const TestMesh mesh = testing::joined(testing::shuffled(testing::torus(24, 12), 3), testing::sphere(12, 8));
  const RasterPart part = part_of(mesh);
  for (const double distance : {0.0, 2.0}) {
    const View view{{0.6, 0, 0.8}, distance};
    const HeatMap map = heat_map({&part, 1}, view, 64);
    EXPECT_EQ(map.count, testing::painted({&part, 1}, {{view}, 64}, testing::rising_order(mesh.indices.size() / 3))[0]);
    EXPECT_EQ(std::accumulate(map.times.begin(), map.times.end(), std::uint64_t{0}), map.count.shaded);
    EXPECT_EQ(static_cast<std::uint64_t>(std::ranges::count_if(map.times, [](auto times) { return times > 0; })),
              map.count.visible);
  }
}

TEST(HeatMap, rows_begin_at_the_top) {
  // Back to front, the nearer one in the upper right quarter alone.
  TestMesh mesh =
      testing::joined(quad(0), {{{0, 0, 0.5f}, {1, 0, 0.5f}, {0, 1, 0.5f}, {1, 1, 0.5f}}, {0, 1, 2, 2, 1, 3}});
  const RasterPart part = part_of(mesh);
  const HeatMap map = heat_map({&part, 1}, View{}, 64);
  const auto times = [&](std::size_t row, std::size_t column) { return map.times[row * 64 + column]; };
  EXPECT_EQ(times(24, 40), 2u);
  EXPECT_EQ(times(24, 24), 1u);
  EXPECT_EQ(times(40, 40), 1u);
  EXPECT_EQ(times(0, 0), 0u);
}

}  // namespace
}  // namespace foredraw::heat_map_test
