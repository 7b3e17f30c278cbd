#include <foredraw/draw_orders/draw_orders_product.h>

#include <foredraw/scene/reorder.h>

#include "support/edit_product.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::told_test {
namespace {

TEST(DrawOrdersProduct, TellsWhatTheOrdersTakeBesideOneForEachKeyframe) {
  Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "body"), testing::draw_of(testing::grid(1, 1), "rock")});
  scene.draws[0].levels[0].orders.push_back(scene.draws[0].levels[0].orders[0]);
  testing::edit<DrawOrders>(scene)->tables = {
      {{0}, {{"Walk", {0, 1, 2}}, {"Run", {0}}}, 2, 3, std::vector<std::uint8_t>(24, 1)}};
  const ProductText told = draw_orders_product()->told(scene);
  ASSERT_EQ(told.lines.size(), 1u);
  EXPECT_EQ(told.lines[0],
            "body: 2 x 3 directions, 4 keyframes of 2 clips; 2 orders of 4 triangles: 48 bytes; one for each of 4 "
            "keyframes would take 96 bytes");
  ASSERT_EQ(told.value.list()->size(), 1u);
  const ExtensionValue& one = told.value.list()->front();
  EXPECT_EQ(one.member("orders")->whole(), 2u);
  EXPECT_EQ(one.member("bytes-for-each-keyframe")->whole(), 96u);
  EXPECT_EQ(*one.member("draws")->list()->front().text(), "body");
}

TEST(DrawOrdersProduct, LeavesOutATableWhoseDrawWasOrderedAnewAndKeepsOneWhoseVerticesMoved) {
  Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "body"), testing::draw_of(testing::grid(2, 1), "rock")});
  for (Draw& draw : scene.draws) draw.levels[0].orders.push_back(draw.levels[0].orders[0]);
  testing::edit<DrawOrders>(scene)->tables = {{{0}, {}, 1, 1, {1}}, {{1}, {}, 1, 1, {1}}};
  const Scene before = scene;
  IndexStream& first = scene.draws[0].levels[0].orders[0];
  first = with_triangle_order(first, std::vector<std::uint32_t>{3, 2, 1, 0});
  const auto told = draw_orders_product()->follow(before, scene);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0], "the orders and their table are left out: body was reordered");
  ASSERT_EQ(order_tables(scene).size(), 1u);
  EXPECT_EQ(order_tables(scene)[0].draws, std::vector<DrawId>{1});
  EXPECT_EQ(scene.draws[0].levels[0].orders.size(), 1u);
  EXPECT_EQ(scene.draws[1].levels[0].orders.size(), 2u);
}

/// Two draws that nodes show, each in two orders, with a sequence for each.
Scene in_sequence() {
  Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "body"), testing::draw_of(testing::grid(2, 1), "hat")});
  for (Draw& draw : scene.draws) draw.levels[0].orders.push_back(draw.levels[0].orders[0]);
  OrderTable table{{0, 1}, {}, 1, 2, {0, 1}};
  table.parts = {{0, 0}, {1, 1}};
  table.sequences = {0, 1, 1, 0};
  testing::edit<DrawOrders>(scene)->tables = {table};
  return scene;
}

TEST(DrawOrdersProduct, TellsThatDrawsHaveSequences) {
  const ProductText told = draw_orders_product()->told(in_sequence());
  ASSERT_EQ(told.lines.size(), 1u);
  EXPECT_EQ(told.lines[0],
            "body, hat: 1 x 2 directions; 2 orders of 8 triangles: 96 bytes; 2 draws in a sequence for each order");
  EXPECT_EQ(told.value.list()->front().member("parts-in-sequence")->whole(), 2u);
}

TEST(DrawOrdersProduct, LeavesOutATableWhosePartsAreGoneAndItsSequencesWithATableThatGoes) {
  const Scene before = in_sequence();
  Scene renumbered = before;
  const auto row = draw_orders_product();
  EXPECT_TRUE(row->follow(before, renumbered).empty());
  EXPECT_EQ(order_tables(renumbered)[0], order_tables(before)[0]);
  EXPECT_EQ(row->difference(before), "");

  Scene elsewhere = before;
  elsewhere.nodes[1].mesh.reset();
  EXPECT_NE(row->difference(elsewhere), "");
  ASSERT_EQ(row->follow(before, elsewhere).size(), 1u);
  EXPECT_TRUE(order_tables(elsewhere).empty());

  Scene reordered = before;
  IndexStream& first = reordered.draws[1].levels[0].orders[0];
  first = with_triangle_order(first, std::vector<std::uint32_t>{3, 2, 1, 0});
  ASSERT_EQ(row->follow(before, reordered).size(), 1u);
  EXPECT_TRUE(order_tables(reordered).empty());
}

}  // namespace
}  // namespace foredraw::told_test
