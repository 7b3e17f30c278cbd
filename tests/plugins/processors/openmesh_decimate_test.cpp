#include "plugins/processors/openmesh_decimate/openmesh_decimate.h"

#include "support/collapses.h"

#include <foredraw/analysis/closest_points.h>

#include <gtest/gtest.h>

namespace foredraw {
namespace {

using testing::TestMesh;

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, OpenmeshDecimateOptions options = {}) {
  options.least = triangles;
  return testing::coarse(mesh, openmesh_decimate(mesh.positions, mesh.indices, options), triangles);
}

TEST(OpenmeshDecimate, ASphereStaysClosedAndRound) {
  const TestMesh sphere = testing::sphere(96, 48);
  const TestMesh left = coarse(sphere, sphere.indices.size() / 30);
  EXPECT_LE(left.indices.size(), sphere.indices.size() / 10);
  EXPECT_LT(testing::distance(sphere, left), 0.05);
}

TEST(OpenmeshDecimate, ATorusStaysATorus) {
  const TestMesh left = coarse(testing::closed_torus(64, 32), 200);
  EXPECT_LE(left.indices.size() / 3, 200u);
  EXPECT_EQ(testing::euler(left), 0);
  EXPECT_EQ(testing::edges(left).size(), 1u);  // all of two triangles
}

TEST(OpenmeshDecimate, BothRimsOfARingStay) {
  const TestMesh ring = testing::flat_ring(64, 8);
  const TestMesh left = coarse(ring, 200);
  EXPECT_LE(left.indices.size() / 3, 200u);
  EXPECT_EQ(testing::euler(left), 0);
}

TEST(OpenmeshDecimate, AFlatPlateKeepsItsOutline) {
  const TestMesh plate = testing::grid(40, 40);
  const TestMesh left = coarse(plate, 400);
  EXPECT_LE(left.indices.size() / 3, 400u);
  EXPECT_EQ(testing::euler(left), 1);
}

TEST(OpenmeshDecimate, SeamsStayClosed) {
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

TEST(OpenmeshDecimate, TakesWhateverItIsGiven) {
  for (const TestMesh& mesh : testing::odd_meshes()) {
    for (const bool with_all : {false, true}) {
      OpenmeshDecimateOptions options;
      if (with_all) {
        options = {.normal_flipping = 60,
                   .normal_deviation = 90,
                   .aspect_ratio = 20,
                   .roundness = 0.01,
                   .edge_length = 0.5,
                   .hausdorff = 0.1};
      }
      const CollapseSequence sequence = openmesh_decimate(mesh.positions, mesh.indices, options);
      EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
    }
  }
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

TEST(OpenmeshDecimate, StopsWhereItIsToldTo) {
  const TestMesh torus = testing::closed_torus(32, 16);
  const CollapseSequence sequence = openmesh_decimate(torus.positions, torus.indices, {.least = 500});
  const Replay run = replay(sequence, torus.positions, torus.indices);
  EXPECT_LE(run.triangles.back(), 500u);
  EXPECT_GE(run.triangles.back(), 498u);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(openmesh_decimate(torus.positions, torus.indices, {.cancel = &cancel}).collapses.empty());
}

}  // namespace
}  // namespace foredraw
