#include <foredraw/analysis/order_nodes.h>

#include <foredraw/analysis/view_directions.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw {
namespace {

constexpr double pi = 3.14159265358979323846;

TEST(GridDirections, AreTheMiddlesOfTheCells) {
  const Directions grid = grid_directions(4, 6);
  ASSERT_EQ(grid.size(), 24u);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double theta = (static_cast<double>(i / 6) + 0.5) / 4 * pi;
    const double phi = (static_cast<double>(i % 6) + 0.5) / 6 * 2 * pi - pi;
    EXPECT_NEAR(std::acos(grid[i].y), theta, 1e-9);
    EXPECT_NEAR(std::atan2(grid[i].z, grid[i].x), phi, 1e-9);
  }
}

TEST(OrderTable, NamesTheOrderOfTheNearestView) {
  const Views views{{{{0, 1, 0}}, {{0, -1, 0}}, {{1, 0, 0}}, {{-1, 0, 0}}}};
  const std::vector<std::uint8_t> serving = {7, 8, 9, 6};
  const OrderTable table = order_table({}, {}, views, serving, {3, 4});
  EXPECT_TRUE(table.clips.empty());
  ASSERT_EQ(table.order.size(), table.cells());
  // Cells around the poles see 30 degrees off them; of those around the equator two see +X and two -X.
  EXPECT_EQ(table.order, (std::vector<std::uint8_t>{7, 7, 7, 7, 6, 9, 9, 6, 8, 8, 8, 8}));
}

TEST(OrderTable, HoldsKeyframesClipByClip) {
  Scene scene;
  scene.animations.resize(2);
  scene.animations[0].name = "Walk";
  scene.animations[1].name = "Run";
  const Poses poses{{{1, 0.5}, {0, 0.25}, {1, 0.75}}};
  const std::vector<std::uint8_t> serving = {1, 2, 3};
  const OrderTable table = order_table(scene, poses, {{{{0, 0, 1}}}}, serving, {1, 1});
  ASSERT_EQ(table.clips.size(), 2u);
  EXPECT_EQ(table.clips[0].name, "Walk");
  EXPECT_EQ(table.clips[0].times, (std::vector<float>{0.25f}));
  EXPECT_EQ(table.clips[1].name, "Run");
  EXPECT_EQ(table.clips[1].times, (std::vector<float>{0.5f, 0.75f}));
  EXPECT_EQ(table.order, (std::vector<std::uint8_t>{2, 1, 3}));
}

}  // namespace
}  // namespace foredraw
