#include <foredraw/collapses/attribute_walk.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::attribute_walk_test {
namespace {

/// Three by two squares; the edge in the middle, from `left` to `right`, collapses to `place`.
class Walk : public ::testing::Test {
 protected:
  std::vector<JoinedVertex> joined(glm::vec3 place, bool solves = true, float blend = 0.5f) {
    const CollapseSequence sequence{.collapses = {{right, left, blend, 0}},
                                    .pairs = {{right, left}},
                                    .first_pair = {0, 1},
                                    .places = {place.x, place.y, place.z},
                                    .solves = solves};
    AttributeWalk walk(sequence, mesh_.positions, mesh_.indices);
    const auto found = walk.next();
    return {found.begin(), found.end()};
  }

  const testing::TestMesh mesh_ = testing::grid(3, 2);
  const std::uint32_t left = 5, right = 6;
};

TEST_F(Walk, LooksAtAllThatIsAround) {
  ASSERT_EQ(mesh_.positions[left], glm::vec3(1, 1, 0));
  ASSERT_EQ(mesh_.positions[right], glm::vec3(2, 1, 0));
  const auto found = joined({1.5f, 1.1f, 0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].vertex, left);
  EXPECT_EQ(found[0].removed, right);
  EXPECT_EQ(found[0].shares.size(), 10u);
  const auto x = [&](std::uint32_t v) { return double{mesh_.positions[v].x}; };
  EXPECT_NEAR(shared_number(std::span<const WedgeShare>(found[0].shares), x), 1.5, 1e-6);
}

TEST_F(Walk, WhatStaysAtAnEndIsWhatItWasThere) {
  for (const glm::vec3 place : {mesh_.positions[left], mesh_.positions[right]}) {
    const auto found = joined(place);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].removed, right);
    EXPECT_TRUE(found[0].shares.empty());
  }
}

TEST_F(Walk, SequencesThatBlendDo) {
  const auto found = joined({1.5f, 1.1f, 0}, false);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].shares.empty());
}

/// Two sheets that meet in a line, each with vertices of its own there: the edge between lies on the line.
TEST(AttributeWalk, NothingComesAcrossASeam) {
  const std::vector<glm::vec3> positions{{0, 0, 0},  {1, 0, 0},  {2, 0, 0},  {3, 0, 0},  // of the upper sheet
                                         {0, 0, 0},  {1, 0, 0},  {2, 0, 0},  {3, 0, 0},  // of the lower one
                                         {0, 1, 0},  {1, 1, 0},  {2, 1, 0},  {3, 1, 0},  //
                                         {0, -1, 0}, {1, -1, 0}, {2, -1, 0}, {3, -1, 0}};
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (const auto& [near, far] : {std::pair(0u, 8u), std::pair(12u, 4u)}) {
      const std::uint32_t a = near + i, b = near + i + 1, c = far + i, d = far + i + 1;
      indices.insert(indices.end(), {a, b, c, c, b, d});
    }
  }
  const CollapseSequence sequence{.collapses = {{2, 1, 0.5f, 0}},
                                  .pairs = {{2, 1}, {6, 5}},
                                  .first_pair = {0, 2},
                                  .places = {1.5f, 0, 0.1f},
                                  .solves = true};
  AttributeWalk walk(sequence, positions, indices);
  const auto found = walk.next();
  ASSERT_EQ(found.size(), 2u);
  for (const JoinedVertex& one : found) {
    EXPECT_FALSE(one.shares.empty());
    for (const WedgeShare& share : one.shares) {
      const bool is_upper = share.vertex < 4 || (share.vertex >= 8 && share.vertex < 12);
      EXPECT_EQ(is_upper, one.vertex == 1) << share.vertex;
    }
  }
}

/// A point of two vertices takes in one of its sheets' points. The other vertex moves with it, and looks at its own.
TEST(AttributeWalk, TheOtherVertexOfThePointMovesToo) {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 1, 0},  {-1, 1, 0}, {0, 2, 0},  // the sheet with the edge 0 3
                                         {0, 0, 0}, {1, -1, 0}, {-1, -1, 0}};
  const std::vector<std::uint32_t> indices{0, 1, 3, 0, 3, 2, 4, 6, 5};
  const CollapseSequence sequence{
      .collapses = {{3, 0, 0.1f, 0}}, .pairs = {{3, 0}}, .first_pair = {0, 1}, .places = {0, 0.2f, 0}, .solves = true};
  AttributeWalk walk(sequence, positions, indices);
  const auto found = walk.next();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].vertex, 0u);
  EXPECT_EQ(found[1].vertex, 4u);
  EXPECT_EQ(found[1].removed, JoinedVertex::none);
  const auto y = [&](std::uint32_t v) { return double{positions[v].y}; };
  EXPECT_NEAR(shared_sum(std::span<const WedgeShare>(found[1].shares), y), 0.2, 1e-6);
}

/// Triangles without area, and corners that follow from two collapses.
TEST(AttributeWalk, FollowsWhatHasCollapsedBefore) {
  const testing::TestMesh mesh = testing::grid(3, 2);
  std::vector<std::uint32_t> indices = mesh.indices;
  indices.insert(indices.begin(), {5, 5, 6});
  const CollapseSequence sequence{.collapses = {{6, 5, 0.5f, 0}, {7, 5, 0.5f, 0}},
                                  .pairs = {{6, 5}, {7, 5}},
                                  .first_pair = {0, 1, 2},
                                  .places = {1.5f, 1, 0, 2.5f, 1, 0},
                                  .solves = true};
  AttributeWalk walk(sequence, mesh.positions, indices);
  std::vector<double> x;
  for (const glm::vec3& at : mesh.positions) x.push_back(at.x);
  for (const double want : {1.5, 2.5}) {
    const auto found = walk.next();
    ASSERT_EQ(found.size(), 1u);
    ASSERT_FALSE(found[0].shares.empty());
    for (const WedgeShare& share : found[0].shares) EXPECT_NE(share.vertex, want == 2.5 ? 6u : 99u);
    x[5] = shared_number(std::span<const WedgeShare>(found[0].shares), [&](std::uint32_t v) { return x[v]; });
    EXPECT_NEAR(x[5], want, 1e-6);
  }
}

/// Two vertices of a point become one: it is blended with the first of them, and not twice.
TEST(AttributeWalk, WhatTwoBecomeIsBlendedOnce) {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const std::vector<std::uint32_t> indices{0, 1, 3, 0, 4, 2};
  const CollapseSequence sequence{.collapses = {{1, 0, 0.5f, 0}}, .pairs = {{1, 0}, {2, 0}}, .first_pair = {0, 2}};
  AttributeWalk walk(sequence, positions, indices);
  const auto found = walk.next();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].vertex, 0u);
  EXPECT_EQ(found[0].removed, 1u);
}

}  // namespace
}  // namespace foredraw::attribute_walk_test
