#include "plugins/processors/openmesh_decimate/openmesh_decimate.h"

#include "support/collapses.h"

#include <foredraw/analysis/closest_points.h>

#include <gtest/gtest.h>

namespace foredraw::openmesh_decimate_test {
namespace {

using testing::TestMesh;

testing::Simplify with(OpenmeshDecimateOptions options) {
  return [options](const TestMesh& mesh, std::size_t least) mutable {
    options.least = least;
    return openmesh_decimate(mesh.positions, mesh.indices, options);
  };
}

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, const OpenmeshDecimateOptions& options = {}) {
  return testing::coarse(mesh, with(options)(mesh, triangles), triangles);
}

TEST(OpenmeshDecimate, ASphereStaysClosedAndRound) {
  const TestMesh sphere = testing::sphere(96, 48);
  const TestMesh left = coarse(sphere, sphere.indices.size() / 30);
  EXPECT_LE(left.indices.size(), sphere.indices.size() / 10);
  EXPECT_LT(testing::distance(sphere, left), 0.05);
}

/// What a module refuses is refused: fewer edges collapse.
TEST(OpenmeshDecimate, ModulesRefuse) {
  const TestMesh torus = testing::closed_torus(32, 16);
  const auto collapses = [&](const OpenmeshDecimateOptions& options) {
    return openmesh_decimate(torus.positions, torus.indices, options).collapses.size();
  };
  const std::size_t all = collapses({});
  EXPECT_LT(collapses({.normal_deviation = 20}), all);
  EXPECT_LT(collapses({.aspect_ratio = 2}), all);
  EXPECT_LT(collapses({.roundness = 0.4}), all);
  EXPECT_LT(collapses({.edge_length = 0.05}), all);
  const OpenmeshDecimateOptions near{.hausdorff = 0.01};
  EXPECT_LT(collapses(near), all);
  const TestMesh left = coarse(torus, 0, near);
  const ClosestPoints surface(Surface{left.positions, left.indices});
  const double diagonal = 4.04;  // of a box 2.8 by 2.8 by 0.8
  for (const std::uint32_t v : torus.indices) EXPECT_LT(surface.distance(torus.positions[v]), 0.01 * diagonal);
}

TEST(OpenmeshDecimate, TopologyStays) { testing::expect_topology_stays(with({})); }

TEST(OpenmeshDecimate, SeamsStay) { testing::expect_seams_stay(with({})); }

TEST(OpenmeshDecimate, TakesWhateverItIsGiven) {
  testing::expect_odd_meshes_run(with({}));
  testing::expect_odd_meshes_run(with({.normal_flipping = 60,
                                       .normal_deviation = 90,
                                       .aspect_ratio = 20,
                                       .roundness = 0.01,
                                       .edge_length = 0.5,
                                       .hausdorff = 0.1}));
}

/// Its time would grow with the cube of the triangles around it.
TEST(OpenmeshDecimate, AHubStaysAndWhatIsAroundItGoes) {
  const TestMesh hub = testing::spokes(2000);
  const CollapseSequence sequence = openmesh_decimate(hub.positions, hub.indices);
  EXPECT_EQ(replay(sequence, hub.positions, hub.indices).mistake, "");
  EXPECT_GT(sequence.collapses.size(), 1000u);
  for (const Collapse& collapse : sequence.collapses) EXPECT_NE(collapse.removed, 0u);
}

TEST(OpenmeshDecimate, StopsWhereItIsToldTo) {
  testing::expect_it_stops(with({}));
  const TestMesh torus = testing::closed_torus(16, 8);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(openmesh_decimate(torus.positions, torus.indices, {.cancel = &cancel}).collapses.empty());
}

}  // namespace
}  // namespace foredraw::openmesh_decimate_test
