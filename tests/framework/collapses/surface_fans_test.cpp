#include "support/collapses.h"

#include <foredraw/collapses/surface_fans.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace foredraw::surface_fans_test {
namespace {

using testing::TestMesh;

SurfaceFans fans_of(const TestMesh& mesh) {
  return surface_fans(CollapseRecorder(mesh.positions, mesh.indices).points());
}

std::size_t held(const SurfaceFans& fans) { return static_cast<std::size_t>(std::ranges::count(fans.is_held, true)); }

TEST(SurfaceFans, OfAManifoldAreItsPoints) {
  const TestMesh torus = testing::closed_torus(16, 8);
  const SurfaceFans fans = fans_of(torus);
  EXPECT_EQ(fans.point.size(), 16u * 8u);
  EXPECT_EQ(held(fans), 0u);
  const SurfaceFans of_box = fans_of(testing::box_of_sides(3));
  EXPECT_EQ(of_box.point.size(), 56u);
  EXPECT_EQ(held(of_box), 0u);
}

TEST(SurfaceFans, OnePointOfTwoSheetsIsTwo) {
  const TestMesh plate = testing::grid(3, 3);
  const TestMesh two = testing::joined(plate, testing::moved(plate, -plate.positions.back()));
  const SurfaceFans fans = fans_of(two);
  EXPECT_EQ(fans.point.size(), 32u);
  EXPECT_EQ(held(fans), 2u);
}

TEST(SurfaceFans, ThreeSheetsComeApartAlongTheirEdge) {
  TestMesh book;  // of three pages with one triangle each
  book.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  book.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  const SurfaceFans fans = fans_of(book);
  EXPECT_EQ(fans.point.size(), 9u);
  EXPECT_EQ(held(fans), 6u);
}

/// Whatever comes in: no two triangles have an edge in one direction, and each fan is of one point.
TEST(SurfaceFans, AreManifold) {
  for (const TestMesh& mesh : testing::odd_meshes()) {
    const CollapseRecorder recorder(mesh.positions, mesh.indices);
    const SurfaceFans fans = surface_fans(recorder.points());
    ASSERT_EQ(fans.corners.size(), recorder.points().size());
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (std::size_t t = 0; t < fans.corners.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(fans.point[fans.corners[t][k]], recorder.points()[t][k]);
        EXPECT_TRUE(sides.insert({fans.corners[t][k], fans.corners[t][(k + 1) % 3]}).second);
      }
    }
  }
}

TEST(SurfaceFans, AMoebiusStripIsCutOnce) {
  const SurfaceFans fans = fans_of(testing::moebius_strip(40));
  EXPECT_GT(held(fans), 0u);
  EXPECT_LT(held(fans), 20u);
}

}  // namespace
}  // namespace foredraw::surface_fans_test
