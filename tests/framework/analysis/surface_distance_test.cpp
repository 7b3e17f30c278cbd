#include <foredraw/analysis/surface_distance.h>

#include "support/meshes.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw {
namespace {

using testing::TestMesh;

Surface surface_of(const TestMesh& mesh) { return {mesh.positions, mesh.indices}; }

TestMesh moved(TestMesh mesh, glm::vec3 by) {
  for (glm::vec3& p : mesh.positions) p += by;
  return mesh;
}

SurfaceDistance between(const TestMesh& a, const TestMesh& b, SurfaceDistanceOptions options = {}, int threads = 2) {
  const Executor executor(threads);
  return *surface_distance(surface_of(a), surface_of(b), options, executor);
}

/// The distance by trying every triangle, each by many points of its own.
double by_hand(const TestMesh& mesh, glm::dvec3 point) {
  double nearest = std::numeric_limits<double>::infinity();
  constexpr int steps = 60;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t c) { return glm::dvec3(mesh.positions[mesh.indices[i + c]]); };
    for (int u = 0; u <= steps; ++u) {
      for (int v = 0; u + v <= steps; ++v) {
        const glm::dvec3 at =
            corner(0) + (corner(1) - corner(0)) * (u / double{steps}) + (corner(2) - corner(0)) * (v / double{steps});
        nearest = std::min(nearest, glm::length(at - point));
      }
    }
  }
  return nearest;
}

TEST(ClosestPoints, FindsWhatTryingAllFinds) {
  const TestMesh mesh = testing::soup(40, 3);
  const ClosestPoints closest(surface_of(mesh));
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 point(3 * random.unit() - 1, 3 * random.unit() - 1, 3 * random.unit() - 1);
    const double found = closest.distance(point);
    const double tried = by_hand(mesh, point);
    EXPECT_LE(found, tried + 1e-12);
    EXPECT_GT(found, tried - 0.06);
  }
}

TEST(ClosestPoints, OfTrianglesThatAreALineOrAPoint) {
  const TestMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2}};
  EXPECT_DOUBLE_EQ(ClosestPoints(surface_of(line)).distance({1.5, 2, 0}), 2);
  EXPECT_DOUBLE_EQ(ClosestPoints(surface_of(line)).distance({3, 0, 0}), 1);
  const TestMesh point{{{1, 1, 1}}, {0, 0, 0}};
  EXPECT_DOUBLE_EQ(ClosestPoints(surface_of(point)).distance({1, 1, 4}), 3);
}

TEST(SurfaceDistance, OfTheSameIsNone) {
  const SurfaceDistance same = between(testing::torus(20, 12), testing::torus(20, 12));
  EXPECT_NEAR(same.largest, 0, 1e-7);
  EXPECT_NEAR(same.rms, 0, 1e-7);
}

TEST(SurfaceDistance, OfPlanesIsTheirHeight) {
  const SurfaceDistance apart = between(testing::grid(4, 4), moved(testing::grid(4, 4), {0, 0, 0.25f}));
  EXPECT_DOUBLE_EQ(apart.largest, 0.25);
  EXPECT_DOUBLE_EQ(apart.rms, 0.25);
  EXPECT_NEAR(apart.rms_error, 0, 1e-12);
}

TEST(SurfaceDistance, IsMeasuredBothWays) {
  const TestMesh whole = testing::grid(4, 1);
  TestMesh half = whole;
  half.indices.resize(half.indices.size() / 2);
  const double one = between(whole, half).largest;
  EXPECT_GT(one, 0);
  EXPECT_EQ(one, between(half, whole).largest);
}

/// A triangle over which the other surface rises as a ramp: distances are even between 0 and 1.
TEST(SurfaceDistance, RmsIsWithinItsErrors) {
  const TestMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1e6f, 0}, {1, 1e6f, 0}}, {0, 1, 2, 2, 1, 3}};
  TestMesh ramp = flat;
  ramp.positions[1].z = ramp.positions[3].z = 1e-3f;  // so slight that nearest is straight below
  const double expected_error = 1e-3 * std::sqrt(2 * 4.0 / 45 / 512) / (4 / std::sqrt(3));  // squares vary by 4 / 45
  int outside = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SurfaceDistance found = between(flat, ramp, {512, seed});
    EXPECT_NEAR(found.largest, 1e-3, 1e-5);
    EXPECT_NEAR(found.rms_error, expected_error, 0.1 * expected_error);
    outside += std::abs(found.rms - 1e-3 / std::sqrt(3)) > 3 * found.rms_error ? 1 : 0;
  }
  EXPECT_LE(outside, 1);
}

TEST(SurfaceDistance, SaysNothingOfASurfaceThatIsNone) {
  const Executor executor(1);
  const TestMesh mesh = testing::grid(1, 1);
  EXPECT_FALSE(surface_distance(surface_of(mesh), {}, {}, executor));
  EXPECT_EQ(surface_distance({}, {}, {}, executor)->largest, 0);
  TestMesh odd = mesh;
  for (glm::vec3& p : odd.positions) p.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(surface_distance(surface_of(mesh), surface_of(odd), {}, executor));
}

TEST(SurfaceDistance, IsTheSameAtAnyThreadCount) {
  const SurfaceDistance one = between(testing::sphere(12, 8), testing::sphere(24, 16), {}, 1);
  const SurfaceDistance many = between(testing::sphere(12, 8), testing::sphere(24, 16), {}, 4);
  EXPECT_EQ(one.largest, many.largest);
  EXPECT_EQ(one.rms, many.rms);
  EXPECT_EQ(one.rms_error, many.rms_error);
}

}  // namespace
}  // namespace foredraw
