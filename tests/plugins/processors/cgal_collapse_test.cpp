#include "plugins/processors/cgal_collapse/cgal_collapse.h"

#include "support/collapses.h"

#include <gtest/gtest.h>

namespace foredraw::cgal_collapse_test {
namespace {

using testing::TestMesh;

testing::Simplify with(CgalCollapseOptions options) {
  return [options](const TestMesh& mesh, std::size_t least) mutable {
    options.least = least;
    return cgal_collapse(mesh.positions, mesh.indices, options);
  };
}

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, const CgalCollapseOptions& options = {}) {
  return testing::coarse(mesh, with(options)(mesh, triangles), triangles);
}

TEST(CgalCollapse, ASphereStaysClosedAndRound) {
  const TestMesh sphere = testing::sphere(96, 48);
  const TestMesh left = coarse(sphere, sphere.indices.size() / 30);
  EXPECT_LE(left.indices.size(), sphere.indices.size() / 10);
  EXPECT_LT(testing::distance(sphere, left), 0.05);
}

constexpr CgalCost costs[] = {CgalCost::lindstrom_turk, CgalCost::garland_heckbert};

/// A place is what CGAL goes on from: at the end it lies where the sequence says.
TEST(CgalCollapse, PlacesLieNearTheSurface) {
  const TestMesh torus = testing::closed_torus(64, 32);
  for (const CgalCost cost : costs) {
    const TestMesh left = coarse(torus, 400, {.cost = cost});
    EXPECT_LE(left.indices.size() / 3, 400u);
    EXPECT_LT(testing::distance(torus, left), 0.06);
  }
}

TEST(CgalCollapse, TopologyStays) {
  for (const CgalCost cost : costs) testing::expect_topology_stays(with({.cost = cost}));
}

TEST(CgalCollapse, SeamsStay) {
  for (const CgalCost cost : costs) testing::expect_seams_stay(with({.cost = cost}));
}

TEST(CgalCollapse, TakesWhateverItIsGiven) {
  for (const CgalCost cost : costs) testing::expect_odd_meshes_run(with({.cost = cost}));
}

TEST(CgalCollapse, StopsWhereItIsToldTo) {
  testing::expect_it_stops(with({}));
  const TestMesh torus = testing::closed_torus(16, 8);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(cgal_collapse(torus.positions, torus.indices, {.cancel = &cancel}).collapses.empty());
}

}  // namespace
}  // namespace foredraw::cgal_collapse_test
