#include <foredraw/analysis/ray_tree.h>

#include "support/meshes.h"

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::ray_tree_test {
namespace {

using testing::TestMesh;

RayTree tree_of(const TestMesh& mesh, Blocks blocks) {
  const std::vector<Blocks> all(mesh.indices.size() / 3, blocks);
  return {mesh.positions, mesh.indices, all};
}

glm::dvec3 any_direction(Random& random) {
  for (;;) {
    const glm::dvec3 at(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
    const double squared = glm::dot(at, at);
    if (squared > 0.01 && squared <= 1) return at;
  }
}

TEST(RayTree, NothingGetsOutOfAClosedSphere) {
  const TestMesh ball = testing::sphere(24, 13);
  const RayTree tree = tree_of(ball, Blocks::both);
  Random random(1);
  for (int i = 0; i < 20'000; ++i) EXPECT_FALSE(tree.escapes({{0.1, 0.2, -0.1}, any_direction(random)}));
  // Not between two triangles either: through corners, and through the middles of edges.
  const glm::dvec3 from(0);
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    const glm::dvec3 a(ball.positions[ball.indices[i]]), b(ball.positions[ball.indices[i + 1]]);
    EXPECT_FALSE(tree.escapes({from, a}));
    EXPECT_FALSE(tree.escapes({from, a + b}));
  }
  EXPECT_TRUE(tree.escapes({{0, 0, 2}, {0, 0, 1}}));
  EXPECT_FALSE(tree.escapes({{0, 0, 2}, {0, 0, -1}}));
}

/// From within, a camera outside looks at the fronts of what lies between.
TEST(RayTree, WhatBlocksAtOneSideLetsPassFromTheOther) {
  const TestMesh ball = testing::sphere(24, 13);
  EXPECT_FALSE(tree_of(ball, Blocks::front).escapes({{0, 0, 0}, {1, 2, 3}}));
  EXPECT_TRUE(tree_of(ball, Blocks::back).escapes({{0, 0, 0}, {1, 2, 3}}));
  const auto from_within = tree_of(ball, Blocks::both).first({{0, 0, 0}, {1, 2, 3}});
  ASSERT_TRUE(from_within);
  EXPECT_FALSE(from_within->at_front);
  const auto from_outside = tree_of(ball, Blocks::both).first({{0, 0, 3}, {0.01, 0, -1}});
  ASSERT_TRUE(from_outside);
  EXPECT_TRUE(from_outside->at_front);
  EXPECT_NEAR(from_outside->way, 2, 0.1);
  EXPECT_FALSE(tree_of(ball, Blocks::front).first({{0, 0, 0}, {1, 2, 3}}));
  EXPECT_TRUE(tree_of(ball, Blocks::neither).escapes({{0, 0, 0}, {1, 2, 3}}));
}

TEST(RayTree, ATriangleDoesNotBlockItsOwnRayNorWhatIsTooNear) {
  const TestMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};
  const RayTree tree = tree_of(one, Blocks::both);
  EXPECT_FALSE(tree.escapes({{0.2, 0.2, -1}, {0, 0, 1}}));
  EXPECT_TRUE(tree.escapes({.from = {0.2, 0.2, -1}, .direction = {0, 0, 1}, .except = 0}));
  EXPECT_TRUE(tree.escapes({.from = {0.2, 0.2, -1}, .direction = {0, 0, 1}, .nearest = 1}));
  EXPECT_TRUE(tree.escapes({{0.2, 0.2, 0}, {0, 0, 1}}));    // begins on it
  EXPECT_TRUE(tree.escapes({{-1, 0.2, 0}, {1, 0, 0}}));     // sees it edge on
  EXPECT_FALSE(tree.escapes({{0.5, 0.5, 1}, {0, 0, -1}}));  // its edge
}

/// The tree only leaves out what can not be met.
TEST(RayTree, AnswersAsEveryTriangleAskedByItself) {
  const TestMesh heap = testing::soup(300, 7);
  const std::size_t count = heap.indices.size() / 3;
  std::vector<Blocks> blocks;
  Random random(3);
  for (std::size_t t = 0; t < count; ++t) blocks.push_back(static_cast<Blocks>(random.below(4)));
  const RayTree tree(heap.positions, heap.indices, blocks);
  std::vector<RayTree> alone;
  for (std::size_t t = 0; t < count; ++t) {
    alone.push_back(
        RayTree(heap.positions, std::span(heap.indices).subspan(3 * t, 3), std::span(blocks).subspan(t, 1)));
  }
  std::size_t escaped = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 from = any_direction(random);
    const RayTree::Ray ray{from, any_direction(random)};
    bool free = true;
    std::optional<RayTree::Hit> first;
    for (std::uint32_t t = 0; t < count; ++t) {
      free = free && alone[t].escapes(ray);
      const auto hit = alone[t].first(ray);
      if (hit && (!first || hit->way < first->way)) first = RayTree::Hit{t, hit->at_front, hit->way};
    }
    EXPECT_EQ(tree.escapes(ray), free);
    const auto found = tree.first(ray);
    ASSERT_EQ(found.has_value(), first.has_value());
    if (found) {
      EXPECT_EQ(found->triangle, first->triangle);
    }
    escaped += free;
  }
  EXPECT_GT(escaped, 100u);
  EXPECT_LT(escaped, 1990u);
}

TEST(RayTree, WhatIsNotFiniteIsLeftOut) {
  TestMesh mesh = testing::grid(2, 2);
  mesh.positions[4].z = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(tree_of(mesh, Blocks::both).escapes({{0.05, 0.02, 1}, {0, 0, -1}}) &&
               tree_of(testing::grid(2, 2), Blocks::both).escapes({{0.05, 0.02, 1}, {0, 0, -1}}));
  EXPECT_TRUE(RayTree({}, {}, {}).escapes({{0, 0, 0}, {0, 1, 0}}));
}

}  // namespace
}  // namespace foredraw::ray_tree_test
