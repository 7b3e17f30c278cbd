#include <foredraw/overdraw/overdraw_bound.h>

#include <foredraw/overdraw/heat_map.h>
#include <foredraw/viewing/mask.h>
#include <foredraw/viewing/view_set.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace foredraw::overdraw_bound_test {
namespace {

using testing::TestMesh;

constexpr double rounding = 1e-6;  // what slivers at the poles, whose corners are rounded, may take

RasterPart raster_part(const TestMesh& mesh) { return {mesh.positions, mesh.indices}; }

std::optional<double> bound(const TestMesh& mesh, double most = 100) {
  const RasterPart part = raster_part(mesh);
  return overdraw_bound({&part, 1}, most);
}

void turn_round(TestMesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
}

/// What the triangles overdraw in their own order, over many orthographic views.
double measured(const TestMesh& mesh) {
  const RasterPart part = raster_part(mesh);
  OverdrawCount sum;
  ViewSet set;
  set.views = "fibonacci";
  set.count = 100;
  const Views views = make_views(set);
  for (const View& view : views.views) sum += heat_map({&part, 1}, view, 128).count;
  return static_cast<double>(sum.shaded) / static_cast<double>(sum.visible);
}

TEST(OverdrawBound, IsOneOfWhatIsConvex) {
  EXPECT_NEAR(bound(testing::sphere(32, 16)).value(), 1, rounding);
  EXPECT_NEAR(bound(testing::sphere(8, 4, 0.5f, {10, -20, 3})).value(), 1, rounding);
  EXPECT_EQ(bound(testing::grid(3, 5)), 1);  // a sheet, seen from its front
  TestMesh half = testing::sphere(32, 16);
  half.indices.resize(half.indices.size() / 2 / 3 * 3);
  EXPECT_NEAR(bound(half).value(), 1, rounding);
}

TEST(OverdrawBound, IsNeverBelowWhatAnOrderOverdraws) {
  // A ball with a knob, the knob drawn last or first.
  for (const float size : {0.02f, 0.1f, 0.3f}) {
    TestMesh ball = testing::sphere(48, 24);
    const TestMesh knob = testing::sphere(16, 8, size, {0, 0, 1 + size / 2});
    const TestMesh knob_last = testing::joined(ball, knob);
    const TestMesh knob_first = testing::joined(knob, ball);
    const double most = bound(knob_last).value();
    EXPECT_GE(most * (1 + 1e-3), measured(knob_last)) << size;
    EXPECT_GE(most * (1 + 1e-3), measured(knob_first)) << size;
    EXPECT_NEAR(bound(knob_first).value(), most, 1e-12);
  }
}

TEST(OverdrawBound, IsThereOnlyWhereItIsSmall) {
  const TestMesh knobbed = testing::joined(testing::sphere(48, 24), testing::sphere(16, 8, 0.1f, {0, 0, 1.05f}));
  const double value = bound(knobbed).value();
  EXPECT_GT(value, 1.001);
  EXPECT_LT(value, 1.2);
  EXPECT_FALSE(bound(knobbed, 1.001));
  EXPECT_TRUE(bound(knobbed, value * 1.0001));
  const TestMesh nested = testing::joined(testing::sphere(32, 16, 0.9f), testing::sphere(32, 16));
  EXPECT_GT(bound(nested).value(), 1.7);
}

TEST(OverdrawBound, KnowsInsideFromOutside) {
  TestMesh hollow = testing::sphere(16, 8);
  turn_round(hollow);
  EXPECT_FALSE(bound(hollow));  // nothing of it is on the hull and faces outwards
  RasterPart mirrored = raster_part(hollow);
  mirrored.is_mirrored = true;
  EXPECT_NEAR(overdraw_bound({&mirrored, 1}, 2).value(), 1, rounding);
  RasterPart both_sides = raster_part(hollow);
  both_sides.culls_back_faces = false;
  EXPECT_NEAR(overdraw_bound({&both_sides, 1}, 3).value(), 2, 2 * rounding);  // its inner side may be drawn first
}

TEST(OverdrawBound, CountsNoSurfaceWithHolesAsOneThatHides) {
  const TestMesh ball = testing::sphere(16, 8);
  RasterPart masked = raster_part(ball);
  masked.mask = std::make_shared<Mask>();
  EXPECT_FALSE(overdraw_bound({&masked, 1}, 100));
}

TEST(OverdrawBound, IsNotThereOfNothingOrOfNoNumbers) {
  EXPECT_FALSE(overdraw_bound({}, 100));
  TestMesh broken = testing::sphere(16, 8);
  broken.positions[5].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(bound(broken));
  TestMesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.indices = {0, 1, 2};
  EXPECT_FALSE(bound(flat));
}

TEST(OverdrawBound, DependsOnNoOrder) {
  const TestMesh mesh = testing::joined(testing::sphere(24, 12), testing::sphere(12, 6, 0.2f, {1, 0, 0}));
  const double most = bound(mesh).value();
  TestMesh turned = mesh;
  for (std::size_t a = 0, b = turned.indices.size() - 3; a < b; a += 3, b -= 3) {
    for (std::size_t i = 0; i < 3; ++i) std::swap(turned.indices[a + i], turned.indices[b + i]);
  }
  EXPECT_NEAR(bound(turned).value(), most, 1e-12);
}

}  // namespace
}  // namespace foredraw::overdraw_bound_test
