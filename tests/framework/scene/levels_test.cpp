#include <foredraw/scene/levels.h>
#include <foredraw/scene/order_table.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::scene_levels_test {
namespace {

Draw three_levels() {
  Draw draw = testing::draw_of(testing::grid(4, 1), "Rock");
  draw.levels.push_back(testing::draw_of(testing::grid(2, 1)).full());
  draw.levels.push_back(testing::draw_of(testing::grid(1, 1)).full());
  return draw;
}

TEST(Levels, TraitsAreTheAssetsAndThoseMadeAtTheLevel) {
  Draw draw = three_levels();
  draw.levels[1].made.add(traits::clustered);
  EXPECT_EQ(traits_of(draw), Traits{traits::triangles});
  EXPECT_EQ(traits_of(draw, 1), (Traits{traits::triangles, traits::clustered}));
}

TEST(Levels, ADrawWithFewerIsItsCoarsest) {
  const Draw draw = three_levels();
  EXPECT_EQ(at_level(draw, 9).full().vertices, draw.levels[2].vertices);
  EXPECT_EQ(at_level(draw, 9).levels.size(), 1u);
  EXPECT_EQ(&draw.level(9), &draw.levels[2]);
}

TEST(Levels, ProductsAreOfFullDetail) {
  Scene scene = testing::scene_of({three_levels()});
  scene.products.set(DrawOrders{});
  EXPECT_EQ(most_levels(scene), 3u);
  EXPECT_TRUE(at_level(scene, 0).products.has(DrawOrders::product));
  EXPECT_TRUE(at_level(scene, 1).products.empty());
}

TEST(Levels, WhatWasHandedOutComesBackToItsLevel) {
  Draw draw = three_levels();
  Draw changed = at_level(draw, 1);
  changed.name = "another";
  changed.full().error = 7;
  put_level(draw, 1, changed);
  EXPECT_EQ(draw.levels[1].error, 7);
  EXPECT_EQ(draw.name, "Rock");
  put_level(draw, 0, changed);
  EXPECT_EQ(draw.levels.size(), 3u);
  EXPECT_EQ(draw.full().error, 7);
  EXPECT_EQ(draw.name, "another");
}

TEST(Levels, ADrawWithoutOthersMayComeBackWithSome) {
  Draw draw = testing::draw_of(testing::grid(4, 1));
  put_level(draw, 0, three_levels());
  EXPECT_EQ(draw.levels.size(), 3u);
}

TEST(Levels, NamesTellTheLevelBeyondFullDetail) {
  EXPECT_EQ(name_of(three_levels(), 0), "Rock");
  EXPECT_EQ(name_of(three_levels(), 2), "Rock (level 2)");
}

}  // namespace
}  // namespace foredraw::scene_levels_test
