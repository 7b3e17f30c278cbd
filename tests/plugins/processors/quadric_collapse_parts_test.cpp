#include "plugins/processors/quadric_collapse/quadric_collapse.h"

#include "support/collapses.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::quadric_collapse_parts_test {
namespace {

using testing::distance;
using testing::joined;
using testing::moved;
using testing::TestMesh;

/// A ball, and around it many small rings, which can not become fewer than 14 triangles each.
TestMesh ball_and_rings(float size) {
  TestMesh all = testing::sphere(48, 24);
  TestMesh ring = testing::closed_torus(8, 6);
  for (glm::vec3& p : ring.positions) p *= size;
  for (int i = 0; i < 60; ++i) {
    const double angle = 6.283185307179586 * i / 60;
    all = joined(all, moved(ring, glm::vec3(1.02 * std::cos(angle), 1.02 * std::sin(angle), 0)));
  }
  return all;
}

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, QuadricCollapseOptions options = {},
                std::span<const std::uint32_t> stream = {}) {
  options.least = triangles;
  return testing::coarse(mesh, quadric_collapse(mesh.positions, mesh.indices, options, {}, stream), triangles);
}

TEST(QuadricCollapseParts, SmallPiecesGoSoThatLargeOnesNeedNot) {
  const TestMesh mesh = ball_and_rings(0.01f);
  const TestMesh left = coarse(mesh, 400), without = coarse(mesh, 400, {.parts = 0});
  EXPECT_LE(left.indices.size() / 3, 400u);
  EXPECT_GE(without.indices.size() / 3, 60u * 14);
  EXPECT_LT(distance(mesh, left), 0.06) << "as far as rings stand out";
}

/// Edges are cheaper than whole pieces as long as there are enough of them.
TEST(QuadricCollapseParts, NothingGoesThatNeedNot) {
  const TestMesh mesh = ball_and_rings(0.01f);
  const TestMesh left = coarse(mesh, mesh.indices.size() / 3 / 2);
  EXPECT_LT(distance(mesh, left), 0.01);
}

TEST(QuadricCollapseParts, LargePiecesStay) {
  const TestMesh mesh = ball_and_rings(0.1f);
  EXPECT_GE(coarse(mesh, 0).indices.size() / 3, 60u * 14);
  EXPECT_LE(coarse(mesh, 0, {.parts = 1}).indices.size() / 3, 14u) << "one is left of all";
}

/// Vertices of two draws never take each other's place.
TEST(QuadricCollapseParts, PiecesOfTwoDrawsStay) {
  const TestMesh mesh = ball_and_rings(0.01f);
  const std::size_t ball = testing::sphere(48, 24).positions.size();
  std::vector<std::uint32_t> stream(mesh.positions.size(), 0);
  for (std::size_t v = ball; v < stream.size(); ++v) stream[v] = v % 2;
  const CollapseSequence sequence = quadric_collapse(mesh.positions, mesh.indices, {}, {}, stream);
  EXPECT_GE(replay(sequence, mesh.positions, mesh.indices).triangles.back(), 60u * 14);
}

/// Whole sides of a box, of vertices of their own, and single triangles.
TEST(QuadricCollapseParts, SeamsAndBordersAreNoHindrance) {
  TestMesh box = testing::box_of_sides(3);
  for (glm::vec3& p : box.positions) p = p * 0.005f + glm::vec3(2, 0, 0);
  TestMesh single{{{2, 2, 0}, {2.01f, 2, 0}, {2, 2.01f, 0}}, {0, 1, 2}};
  const TestMesh mesh = joined(joined(testing::sphere(16, 8), box), single);
  const TestMesh left = coarse(mesh, 0);
  EXPECT_TRUE(std::ranges::all_of(left.indices, [&](std::uint32_t v) { return left.positions[v].x < 1.5f; }));
  EXPECT_FALSE(left.indices.empty());
}

TEST(QuadricCollapseParts, TheLastPieceStays) {
  const TestMesh ball = testing::sphere(16, 8);
  EXPECT_FALSE(coarse(ball, 0, {.parts = 1}).indices.empty());
}

}  // namespace
}  // namespace foredraw::quadric_collapse_parts_test
