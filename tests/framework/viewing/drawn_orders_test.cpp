#include <foredraw/viewing/drawn_orders.h>

#include <foredraw/scene/order_table.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/viewing/distinct_poses.h>

#include "support/edit_product.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::drawn_orders_test {
namespace {

using Numbers = std::vector<std::uint32_t>;
using Places = std::vector<std::size_t>;

/// A character of three draws; a table draws the first and the last of them in the second order where a look comes from
/// below, and in the second clip also where it comes from above.
Scene character() {
  Scene scene;
  std::vector<Draw> draws;
  for (const char* name : {"head", "hat", "feet"}) {
    Draw draw = testing::draw_of(testing::grid(1, 1), name);
    draw.levels[0].orders.push_back(with_triangle_order(draw.levels[0].orders[0], Numbers{1, 0}));
    draws.push_back(std::move(draw));
  }
  scene = testing::scene_of(std::move(draws));
  Node root;
  root.children = {0, 1, 2};
  scene.nodes.push_back(root);
  scene.skins.resize(1);
  scene.skins[0].joints = {3};
  scene.animations = {{"Sit", {}}, {"Fly", {}}};
  testing::edit<DrawOrders>(scene)->tables.push_back({{0, 2}, {{"Sit", {0}}, {"Fly", {0}}}, 2, 1, {0, 1, 1, 1}});
  return scene;
}

const std::vector<View> up_down_up = {{{0, 1, 0}}, {{0, -1, 0}}, {{0.6, 0.8, 0}}};

TEST(DrawnOrders, views_of_like_orders_come_together) {
  const Scene scene = character();
  const Subject subject = subjects_of(scene)[0];
  const auto sitting = views_by_orders(scene, subject, {0, 0}, up_down_up);
  ASSERT_EQ(sitting.size(), 2u);
  EXPECT_EQ(sitting[0].orders, (Numbers{0, 0, 0}));
  EXPECT_EQ(sitting[0].views, (Places{0, 2}));
  EXPECT_EQ(sitting[1].orders, (Numbers{1, 0, 1}));
  EXPECT_EQ(sitting[1].views, (Places{1}));
  const auto flying = views_by_orders(scene, subject, {1, 0}, up_down_up);
  ASSERT_EQ(flying.size(), 1u);
  EXPECT_EQ(flying[0].orders, (Numbers{1, 0, 1}));
  EXPECT_EQ(flying[0].views, (Places{0, 1, 2}));
  const auto at_rest = views_by_orders(scene, subject, {}, up_down_up);
  ASSERT_EQ(at_rest.size(), 1u);
  EXPECT_EQ(at_rest[0].orders, (Numbers{0, 0, 0}));
}

TEST(DrawnOrders, parts_draw_the_orders_that_are_set) {
  const Scene scene = character();
  const Subject subject = subjects_of(scene)[0];
  Analyses analyses;
  SubjectGeometry posed = subject_geometry(scene, subject, Faces::front, posed_nodes(scene), analyses);
  posed.parts[2].indices = {};  // as one that is not drawn
  const auto drawn = parts_as_drawn(posed, scene, subject, {{1, 0, 1}, {1, 2, 0}, {}});
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_EQ(drawn[2].indices.data(), scene.draws[0].levels[0].orders[1].indices.view().data());
  EXPECT_EQ(drawn[0].indices.data(), scene.draws[1].levels[0].orders[0].indices.view().data());
  EXPECT_TRUE(drawn[1].indices.empty());
}

TEST(DrawnOrders, parts_come_in_the_sequence_of_the_order) {
  Scene scene = character();
  OrderTable& table = testing::edit<DrawOrders>(scene)->tables[0];
  const Subject subject = subjects_of(scene)[0];
  table.parts = subject.parts;
  table.sequences = {0, 1, 2, 2, 0, 1};
  const auto sitting = views_by_orders(scene, subject, {0, 0}, up_down_up);
  ASSERT_EQ(sitting.size(), 2u);
  EXPECT_EQ(sitting[0].sequence, (Numbers{0, 1, 2}));
  EXPECT_EQ(sitting[1].sequence, (Numbers{2, 0, 1}));
  EXPECT_EQ(sitting[1].views, (Places{1}));
  const auto as_in_file = views_by_orders(scene, subject, {0, 0}, up_down_up, SequenceFrom::file);
  ASSERT_EQ(as_in_file.size(), 2u) << "orders are looked up all the same";
  EXPECT_EQ(as_in_file[1].orders, (Numbers{1, 0, 1}));
  EXPECT_EQ(as_in_file[1].sequence, (Numbers{0, 1, 2}));
  const auto at_rest = views_by_orders(scene, subject, {}, up_down_up);
  ASSERT_EQ(at_rest.size(), 1u);
  EXPECT_EQ(at_rest[0].sequence, (Numbers{0, 1, 2})) << "a clip that the table does not have";
}

TEST(DrawnOrders, parts_that_a_table_does_not_name_keep_their_places) {
  Scene scene = character();
  OrderTable& table = testing::edit<DrawOrders>(scene)->tables[0];
  const Subject subject = subjects_of(scene)[0];
  table.parts = {subject.parts[0], {7, 7}, subject.parts[2]};
  table.sequences = {0, 1, 2, 2, 1, 0};
  const auto flying = views_by_orders(scene, subject, {1, 0}, up_down_up);
  ASSERT_EQ(flying.size(), 1u);
  EXPECT_EQ(flying[0].sequence, (Numbers{2, 1, 0}));
}

TEST(DrawnOrders, parts_may_come_by_their_materials) {
  Scene scene = character();
  scene.materials.resize(2);
  scene.draws[0].material = 1;
  scene.draws[1].material = 0;
  scene.draws[2].material = 0;
  for (const ViewsOfOrders& some :
       views_by_orders(scene, subjects_of(scene)[0], {0, 0}, up_down_up, SequenceFrom::material)) {
    EXPECT_EQ(some.sequence, (Numbers{1, 2, 0}));
  }
}

TEST(DrawnOrders, without_tables_all_views_draw_what_stands_alone) {
  Scene scene = character();
  testing::edit<DrawOrders>(scene)->tables.clear();
  const auto all = views_by_orders(scene, subjects_of(scene)[0], {1, 0}, up_down_up);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].orders, (Numbers{0, 0, 0}));
  EXPECT_EQ(all[0].views, (Places{0, 1, 2}));
}

TEST(DrawnOrders, poses_that_are_drawn_in_other_orders_are_not_alike) {
  Scene scene = character();
  const Poses poses{{{0, 0}, {1, 0}, {0, 5}}};
  EXPECT_EQ(distinct_poses(scene, subjects_of(scene), poses, Executor(2))[0].first_alike, (Places{0, 1, 0}));
  testing::edit<DrawOrders>(scene)->tables.clear();
  EXPECT_EQ(distinct_poses(scene, subjects_of(scene), poses, Executor(2))[0].first_alike, (Places{0, 0, 0}));
}

}  // namespace
}  // namespace foredraw::drawn_orders_test
