#include "plugins/processors/cgal_collapse/cgal_collapse.h"

#include "support/collapses.h"

#include <gtest/gtest.h>

namespace foredraw {
namespace {

using testing::TestMesh;

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, CgalCollapseOptions options = {}) {
  options.least = triangles;
  return testing::coarse(mesh, cgal_collapse(mesh.positions, mesh.indices, options), triangles);
}

TEST(CgalCollapse, ASphereStaysClosedAndRound) {
  const TestMesh sphere = testing::sphere(96, 48);
  const TestMesh left = coarse(sphere, sphere.indices.size() / 30);
  EXPECT_LE(left.indices.size(), sphere.indices.size() / 10);
  EXPECT_LT(testing::distance(sphere, left), 0.05);
}

TEST(CgalCollapse, ATorusStaysATorus) {
  const TestMesh left = coarse(testing::closed_torus(64, 32), 200);
  EXPECT_LE(left.indices.size() / 3, 200u);
  EXPECT_EQ(testing::euler(left), 0);
  EXPECT_EQ(testing::edges(left).size(), 1u);  // all of two triangles
}

TEST(CgalCollapse, BothRimsOfARingStay) {
  const TestMesh ring = testing::flat_ring(64, 8);
  const TestMesh left = coarse(ring, 200);
  EXPECT_LE(left.indices.size() / 3, 200u);
  EXPECT_EQ(testing::euler(left), 0);
}

TEST(CgalCollapse, AFlatPlateKeepsItsOutline) {
  const TestMesh plate = testing::grid(40, 40);
  const TestMesh left = coarse(plate, 400);
  EXPECT_LE(left.indices.size() / 3, 400u);
  EXPECT_EQ(testing::euler(left), 1);
}

TEST(CgalCollapse, SeamsStayClosed) {
  const TestMesh box = testing::box_of_sides(8);
  const TestMesh left = coarse(box, 100);
  EXPECT_LE(left.indices.size() / 3, 100u);
  EXPECT_EQ(testing::edges(left).size(), 1u);
  EXPECT_EQ(testing::euler(left), 2);
  const std::size_t of_side = box.positions.size() / 6;  // no triangle takes a vertex of another side
  for (std::size_t i = 0; i < left.indices.size(); i += 3) {
    EXPECT_EQ(left.indices[i] / of_side, left.indices[i + 1] / of_side);
    EXPECT_EQ(left.indices[i] / of_side, left.indices[i + 2] / of_side);
  }
}

constexpr CgalCost costs[] = {CgalCost::lindstrom_turk, CgalCost::garland_heckbert};

TEST(CgalCollapse, TakesWhateverItIsGiven) {
  for (const TestMesh& mesh : testing::odd_meshes()) {
    for (const CgalCost cost : costs) {
      const CollapseSequence sequence = cgal_collapse(mesh.positions, mesh.indices, {.cost = cost});
      EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
    }
  }
}

/// A place is what CGAL goes on from: at the end it lies where the sequence says.
TEST(CgalCollapse, PlacesLieNearTheSurface) {
  const TestMesh torus = testing::closed_torus(64, 32);
  for (const CgalCost cost : costs) {
    const TestMesh left = coarse(torus, 400, {.cost = cost});
    EXPECT_LE(left.indices.size() / 3, 400u);
    EXPECT_LT(testing::distance(torus, left), 0.06);
  }
}

TEST(CgalCollapse, StopsWhereItIsToldTo) {
  const TestMesh torus = testing::closed_torus(32, 16);
  const CollapseSequence sequence = cgal_collapse(torus.positions, torus.indices, {.least = 500});
  const Replay run = replay(sequence, torus.positions, torus.indices);
  EXPECT_LE(run.triangles.back(), 500u);
  EXPECT_GE(run.triangles.back(), 498u);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(cgal_collapse(torus.positions, torus.indices, {.cancel = &cancel}).collapses.empty());
}

}  // namespace
}  // namespace foredraw
