#include <foredraw/analysis/surface_distance.h>

#include "support/collapses.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::surface_distance_test {
namespace {

using testing::moved;
using testing::TestMesh;

Surface surface_of(const TestMesh& mesh) { return {mesh.positions, mesh.indices}; }

SurfaceDistance between(const TestMesh& a, const TestMesh& b, SurfaceDistanceOptions options = {}, int threads = 2) {
  const Executor executor(threads);
  return *surface_distance(surface_of(a), surface_of(b), options, executor);
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

/// The distance is that of the ramp at x, which is evenly spread from 0 to 1.
TEST(SurfaceDistance, MeanAndQuantileAreWithinTheirErrors) {
  const TestMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1e6f, 0}, {1, 1e6f, 0}}, {0, 1, 2, 2, 1, 3}};
  TestMesh ramp = flat;
  ramp.positions[1].z = ramp.positions[3].z = 1e-3f;
  int outside = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const OneWayDistance found = between(flat, ramp, {1024, seed}).there;
    EXPECT_NEAR(found.mean.error, 1e-3 / std::sqrt(12.0 * 1024), 1e-6);
    EXPECT_GT(found.p99.error, 0);
    outside += std::abs(found.mean.value - 0.5e-3) > 3 * found.mean.error ? 1 : 0;
    outside += std::abs(found.p99.value - 0.99e-3) > 3 * found.p99.error ? 1 : 0;
  }
  EXPECT_LE(outside, 2);
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
}  // namespace foredraw::surface_distance_test
