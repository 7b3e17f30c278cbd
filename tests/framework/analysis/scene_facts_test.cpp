#include <foredraw/analysis/scene_facts.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::scene_facts_test {
namespace {

/// Two draws of the same vertices, of which each uses some, and a third one with its own.
Scene scene_that_shares() {
  testing::TestMesh first = testing::grid(1, 1);  // vertices 0 to 3
  first.positions.resize(8);
  first.positions[7].x = std::numeric_limits<float>::infinity();
  testing::TestMesh second = first;
  second.indices = {3, 4, 5};
  Scene scene = testing::scene_of(
      {testing::draw_of(first, "a"), testing::draw_of(second, "b"), testing::draw_of(testing::grid(2, 2), "c")});
  scene.draws[1].levels[0].vertices = scene.draws[0].levels[0].vertices;
  return scene;
}

TEST(SceneFacts, vertices_that_another_draw_uses_are_referenced) {
  Analyses analyses;
  const auto facts = facts_of_draws(scene_that_shares(), analyses, Executor(2));
  ASSERT_EQ(facts.size(), 3u);
  EXPECT_EQ(facts[0].unreferenced_vertices, 2u);  // 6 and 7
  EXPECT_EQ(facts[0].non_finite_positions, 1u);
  EXPECT_EQ(facts[1].unreferenced_vertices, 0u) << "they are counted with the first draw";
  EXPECT_EQ(facts[1].non_finite_positions, 0u);
  EXPECT_EQ(facts[2], (MeshFacts{.triangles = 8, .vertices = 9}));
}

TEST(SceneFacts, shared_vertices_are_counted_once) {
  EXPECT_EQ(count_vertices(scene_that_shares()), 17u);
  EXPECT_EQ(count_vertices(Scene()), 0u);
}

}  // namespace
}  // namespace foredraw::scene_facts_test
