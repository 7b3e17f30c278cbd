#include <foredraw/analysis/crossing_triangles.h>

#include "support/meshes.h"

#include <glm/common.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace foredraw::crossing_triangles_test {
namespace {

using testing::TestMesh;

std::vector<std::uint8_t> crossing(const TestMesh& mesh, int threads = 1) {
  return crossing_triangles({mesh.positions, mesh.indices}, Executor(threads));
}

std::size_t count(const TestMesh& mesh) { return static_cast<std::size_t>(std::ranges::count(crossing(mesh), 1)); }

/// So that it closes to the bit.
TestMesh rounded(TestMesh mesh) {
  for (glm::vec3& p : mesh.positions) p = glm::round(p * 1024.0f) / 1024.0f;
  return mesh;
}

TEST(CrossingTriangles, AreThoseThatGoThroughEachOther) {
  const TestMesh two{
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {5, 5, 1}, {9, 9, 9}, {9, 8, 9}, {8, 9, 9}},
      {0, 1, 2, 3, 4, 5, 6, 7, 8}};
  EXPECT_EQ(crossing(two), (std::vector<std::uint8_t>{1, 1, 0}));
}

TEST(CrossingTriangles, WhatTouchesOrLiesInOnePlaneDoesNotCross) {
  const TestMesh touching{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, 1}, {5, 5, 1}}, {0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(count(touching), 0u);
  const TestMesh flat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {5, 1, 0}, {1, 5, 0}}, {0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(count(flat), 0u);
}

TEST(CrossingTriangles, OfClosedSurfacesAreNone) {
  EXPECT_EQ(count(rounded(testing::torus(60, 30))), 0u);
  EXPECT_EQ(count(rounded(testing::sphere(40, 20))), 0u);
}

/// Two spheres of radius 1 whose middles are one apart meet in a ring.
TEST(CrossingTriangles, OfTwoSpheresLieOnTheirRing) {
  TestMesh both = rounded(testing::sphere(40, 20));
  const TestMesh one = both;
  for (const glm::vec3& p : one.positions) both.positions.push_back(p + glm::vec3(1, 0.01f, 0.02f));
  for (const std::uint32_t v : one.indices)
    both.indices.push_back(v + static_cast<std::uint32_t>(one.positions.size()));
  const auto crosses = crossing(both);
  std::size_t found = 0;
  for (std::size_t t = 0; t < crosses.size(); ++t) {
    found += crosses[t];
    if (crosses[t] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(both.positions[both.indices[3 * t + c]].x, 0.5f, 0.2f);
  }
  EXPECT_GT(found, 80u);
  EXPECT_EQ(crosses, crossing(both, 4)) << "at any number of threads";
}

TEST(CrossingTriangles, BearWhatIsNoSurface) {
  TestMesh odd = testing::soup(300, 5);
  odd.positions[7].x = std::numeric_limits<float>::quiet_NaN();
  odd.positions[9].y = std::numeric_limits<float>::infinity();
  EXPECT_GT(count(odd), 0u);
  EXPECT_EQ(count({}), 0u);
  TestMesh point{std::vector<glm::vec3>(3000, glm::vec3(1)), std::vector<std::uint32_t>(3000)};
  EXPECT_EQ(count(point), 0u);
  for (glm::vec3& p : odd.positions) p *= 1e37f;
  EXPECT_GT(count(odd), 0u);
}

TEST(CrossingTriangles, EndWhenTheyAreCancelled) {
  const std::atomic<bool> cancel = true;
  const TestMesh mesh = testing::soup(300, 5);
  const auto none = crossing_triangles({mesh.positions, mesh.indices}, Executor(1), &cancel);
  EXPECT_EQ(std::ranges::count(none, 1), 0);
}

}  // namespace
}  // namespace foredraw::crossing_triangles_test
