#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/order_grid.h>

#include <gtest/gtest.h>

namespace foredraw::order_grid_test {
namespace {

TEST(OrderNodes, NameTheOrderOfTheNearestView) {
  const Views views{{{{0, 1, 0}}, {{0, -1, 0}}, {{1, 0, 0}}, {{-1, 0, 0}}}};
  const std::vector<std::uint8_t> serving = {7, 8, 9, 6};
  const OrderTable table = order_table({}, {}, views, serving, {3, 4});
  EXPECT_TRUE(table.clips.empty());
  ASSERT_EQ(table.order.size(), table.cells());
  // Cells around the poles see 30 degrees off them; of those around the equator two see +X and two -X.
  EXPECT_EQ(table.order, (std::vector<std::uint8_t>{7, 7, 7, 7, 6, 9, 9, 6, 8, 8, 8, 8}));
}

TEST(OrderNodes, AreKeyframesClipByClip) {
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
}  // namespace foredraw::order_grid_test
