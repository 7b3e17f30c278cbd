#include <foredraw/analysis/farthest_distance.h>

#include "support/collapses.h"
#include "support/meshes.h"

#include <foredraw/analysis/surface_distance.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::farthest_distance_test {
namespace {

using testing::moved;
using testing::TestMesh;

Surface surface_of(const TestMesh& mesh) { return {mesh.positions, mesh.indices}; }

Farthest one_way(const TestMesh& of, const TestMesh& to, const FarthestOptions& options = {}, int threads = 2) {
  return *farthest_distance(surface_of(of), ClosestPoints(surface_of(to)), options, Executor(threads));
}

std::optional<Farthest> both_ways(const Surface& a, const Surface& b) {
  const ClosestPoints of_a(a), of_b(b);
  return hausdorff_distance({a, of_a}, {b, of_b}, {}, Executor(2));
}

Farthest both_ways(const TestMesh& a, const TestMesh& b) { return *both_ways(surface_of(a), surface_of(b)); }

std::optional<bool> within(const TestMesh& of, const TestMesh& to, double distance) {
  return is_within(surface_of(of), ClosestPoints(surface_of(to)), distance, {}, Executor(2));
}

void expect_holds(const Farthest& interval, double truth, double tolerance = FarthestOptions().tolerance) {
  constexpr double slack = 1e-6;
  EXPECT_LE(interval.found, truth + slack);
  EXPECT_GE(interval.bound, truth - slack);
  EXPECT_LE(interval.bound, interval.found * (1 + tolerance) + slack);
  EXPECT_TRUE(interval.is_within_tolerance);
}

/// An octahedron whose triangles are cut into steps * steps, pushed out to the sphere.
TestMesh ball(int steps, bool is_round) {
  TestMesh mesh;
  for (int octant = 0; octant < 8; ++octant) {
    const glm::vec3 sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    const auto at = [&](int u, int v) {
      const glm::vec3 p = glm::vec3(u, v, steps - u - v) / static_cast<float>(steps) * sign;
      mesh.positions.push_back(is_round ? glm::normalize(p) : p);
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size() - 1));
    };
    for (int u = 0; u < steps; ++u) {
      for (int v = 0; u + v < steps; ++v) {
        at(u, v), at(u + 1, v), at(u, v + 1);
        if (u + v + 1 < steps) at(u + 1, v), at(u + 1, v + 1), at(u, v + 1);
      }
    }
  }
  return mesh;
}

TestMesh flat(float side) { return {{{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {side, side, 0}}, {0, 1, 2, 2, 1, 3}}; }

TEST(FarthestDistance, OfPlatesIsTheirHeight) {
  const TestMesh plate = testing::grid(7, 5), above = moved(plate, {0, 0, 0.25f});
  expect_holds(one_way(plate, above), 0.25);
  expect_holds(one_way(flat(5), moved(testing::grid(5, 5), {0, 0, 0.25f})), 0.25);
  EXPECT_DOUBLE_EQ(both_ways(plate, above).found, 0.25);
}

/// The same surface in other triangles is no farther away than floats can tell.
TEST(FarthestDistance, OfTheSameSurfaceIsNone) {
  EXPECT_LT(both_ways(flat(8), testing::grid(8, 8)).bound, 1e-5);
  EXPECT_LT(both_ways(testing::torus(40, 20), testing::shuffled(testing::torus(40, 20), 3)).bound, 1e-6);
  EXPECT_LT(both_ways(ball(1, false), ball(7, false)).bound, 1e-6);
}

/// A roof of that height over a floor from -1 to 1: the ridge is as far as it is high, and from the floor below it the
/// way is down the slope's normal.
TEST(FarthestDistance, OfARoofFromItsFloor) {
  for (const float height : {0.01f, 0.5f, 3.0f}) {
    const TestMesh floor{{{-1, 0, 0}, {1, 0, 0}, {-1, 9, 0}, {1, 9, 0}}, {0, 1, 2, 2, 1, 3}};
    const TestMesh roof{{{-1, 0, 0}, {-1, 9, 0}, {0, 0, height}, {0, 9, height}, {1, 0, 0}, {1, 9, 0}},
                        {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5}};
    expect_holds(one_way(roof, floor), height);
    expect_holds(one_way(floor, roof), height / std::sqrt(1 + height * height));
    expect_holds(both_ways(roof, floor), height);
  }
}

TEST(FarthestDistance, OfAnOctahedronFromTheSphereAroundIt) {
  const double middle_of_a_face = 1 - 1 / std::sqrt(3);
  const TestMesh octahedron = ball(1, true), sphere = ball(30, true);  // 30 is a multiple of 3: a vertex stands there
  expect_holds(one_way(sphere, octahedron), middle_of_a_face);
  // Its own triangles lie below the sphere by less than their side squared over 8.
  const Farthest inside = one_way(octahedron, sphere);
  EXPECT_GT(inside.bound, middle_of_a_face - 1e-3);
  EXPECT_LE(inside.found, middle_of_a_face + 1e-6);
}

/// Two triangles over a plate with a hole no larger than its cells: few samples fall there, and no vertex does.
TEST(FarthestDistance, FindsAHoleThatSamplesMiss) {
  constexpr std::uint32_t side = 100;
  TestMesh plate = testing::grid(side, side);
  const std::uint32_t vertex = 53 * (side + 1) + 37;
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < plate.indices.size(); i += 3) {
    const auto corners = std::span(plate.indices).subspan(i, 3);
    if (std::ranges::find(corners, vertex) == corners.end()) kept.insert(kept.end(), corners.begin(), corners.end());
  }
  ASSERT_EQ(kept.size() + 18, plate.indices.size());
  plate.indices = kept;
  const float width = glm::length(plate.positions[1] - plate.positions[0]);
  const TestMesh whole = flat(width * side);
  expect_holds(one_way(whole, plate), width * std::sqrt(0.5));
  EXPECT_LT(surface_distance(surface_of(whole), surface_of(plate), {256, 1}, Executor(1))->there.largest, 1e-6);
}

TEST(FarthestDistance, NoSampleIsBeyondTheBound) {
  const std::pair<TestMesh, TestMesh> pairs[] = {
      {testing::soup(50, 1), testing::soup(50, 2)},    {testing::soup(5, 3), testing::soup(400, 4)},
      {testing::soup(400, 5), testing::soup(5, 6)},    {testing::torus(12, 8), testing::torus(50, 30)},
      {testing::sphere(9, 7), testing::torus(20, 12)},
  };
  for (const auto& [a, b] : pairs) {
    const auto sampled = surface_distance(surface_of(a), surface_of(b), {40'000, 7}, Executor(2));
    for (const double tolerance : {0.001, 0.02, 0.5}) {
      const Farthest there = one_way(a, b, {tolerance}), back = one_way(b, a, {tolerance});
      EXPECT_LE(sampled->there.largest, there.bound);
      EXPECT_LE(sampled->back.largest, back.bound);
      EXPECT_LE(there.bound, there.found * (1 + tolerance) + 1e-6);
      EXPECT_LE(back.bound, back.found * (1 + tolerance) + 1e-6);
      EXPECT_DOUBLE_EQ(ClosestPoints(surface_of(b)).distance(there.at), there.found);
      EXPECT_GT(there.bound * 1.05, sampled->there.largest);
    }
  }
}

TEST(FarthestDistance, IsTheSameAtAnyThreadCount) {
  const TestMesh a = testing::torus(40, 20), b = testing::torus(90, 50);
  const Farthest one = one_way(a, b, {}, 1), many = one_way(a, b, {}, 4);
  EXPECT_EQ(one.found, many.found);
  EXPECT_EQ(one.bound, many.bound);
  EXPECT_EQ(one.at, many.at);
  EXPECT_EQ(one.questions, many.questions);
}

/// As many as there are triangles on both sides, not as many as samples would be needed.
TEST(FarthestDistance, AsksFewQuestions) {
  const TestMesh a = testing::torus(60, 30), b = testing::torus(120, 60);
  EXPECT_LT(one_way(a, b).questions, 30'000u);
  EXPECT_LT(one_way(b, a).questions, 30'000u);
}

TEST(FarthestDistance, TellsWhereTheQuestionsDidNotSuffice) {
  const TestMesh a = testing::torus(12, 8), b = testing::torus(50, 30);
  const Farthest hasty = one_way(a, b, {.most_questions = 20}), exact = one_way(a, b);
  EXPECT_FALSE(hasty.is_within_tolerance);
  EXPECT_GE(hasty.bound, exact.found);
  EXPECT_LE(hasty.found, exact.bound);
  EXPECT_LT(hasty.questions, 20u + a.positions.size() + 20u);
  EXPECT_EQ(is_within(surface_of(a), ClosestPoints(surface_of(b)), exact.bound, {.most_questions = 20}, Executor(1)),
            std::nullopt);
}

TEST(FarthestDistance, EndsWhenItIsCancelled) {
  const std::atomic<bool> cancel = true;
  const TestMesh a = testing::torus(12, 8), b = testing::torus(50, 30);
  const Farthest nothing_known = one_way(a, b, {.cancel = &cancel});
  EXPECT_FALSE(nothing_known.is_within_tolerance);
  EXPECT_EQ(nothing_known.bound, std::numeric_limits<double>::infinity());
  EXPECT_EQ(nothing_known.questions, 0u);
}

TEST(FarthestDistance, OfTrianglesThatAreALineOrAPoint) {
  const TestMesh plate = testing::grid(4, 4);
  const TestMesh needle{{{1, 1, 0}, {1, 1, 3}, {1, 1, 2}}, {0, 1, 2, 0, 0, 1}};
  const TestMesh point{{{1, 1, 5}}, {0, 0, 0}};
  expect_holds(one_way(needle, plate), 3);
  expect_holds(one_way(point, plate), 5);
  expect_holds(one_way(needle, point), 5);
  EXPECT_GT(one_way(plate, point).found, 5);
}

TEST(FarthestDistance, OfAnySizeAndAnywhere) {
  const TestMesh a = testing::torus(12, 8), b = testing::torus(30, 20);
  const Farthest plain = one_way(a, b);
  for (const float scale : {0x1p-90f, 0x1p90f}) {
    TestMesh small_a = a, small_b = b;
    for (glm::vec3& p : small_a.positions) p *= scale;
    for (glm::vec3& p : small_b.positions) p *= scale;
    const Farthest scaled = one_way(small_a, small_b);
    EXPECT_EQ(scaled.found, plain.found * scale);
    EXPECT_EQ(scaled.bound, plain.bound * scale);
  }
  const Farthest elsewhere = one_way(moved(a, glm::vec3(64)), moved(b, glm::vec3(64)));
  EXPECT_NEAR(elsewhere.found, plain.found, 0.02 * plain.found + 64 * 0x1p-22);
  EXPECT_TRUE(elsewhere.is_within_tolerance);
}

TEST(FarthestDistance, OfNothing) {
  const Executor executor(1);
  const TestMesh mesh = testing::grid(1, 1);
  TestMesh odd = mesh;
  for (glm::vec3& p : odd.positions) p.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(farthest_distance({}, ClosestPoints(surface_of(mesh)), {}, executor)->bound, 0);
  EXPECT_FALSE(farthest_distance(surface_of(mesh), ClosestPoints(surface_of(odd)), {}, executor));
  EXPECT_FALSE(both_ways(surface_of(mesh), surface_of(odd)));
  EXPECT_FALSE(both_ways(surface_of(odd), surface_of(mesh)));
  EXPECT_EQ(both_ways(Surface{}, surface_of(odd))->bound, 0);
  EXPECT_FALSE(is_within(surface_of(mesh), ClosestPoints(Surface{}), 1, {}, executor));
}

TEST(IsWithin, AnswersOnBothSidesOfTheTruth) {
  const TestMesh a = testing::torus(12, 8), b = testing::torus(50, 30);
  const double truth = one_way(a, b, {1e-4}).found;
  for (const double part : {0.1, 0.9, 0.999}) EXPECT_EQ(within(a, b, truth * part), false);
  for (const double part : {1.001, 1.1, 10.0}) EXPECT_EQ(within(a, b, truth * part), true);
  EXPECT_EQ(within(a, a, 0), true);
}

}  // namespace
}  // namespace foredraw::farthest_distance_test
