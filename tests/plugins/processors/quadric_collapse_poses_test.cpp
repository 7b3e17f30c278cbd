#include "plugins/processors/quadric_collapse/quadric_collapse.h"

#include "support/bending_tube.h"
#include "support/collapses.h"

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/measuring/mesh_in_poses.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/pose_set.h>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace foredraw::quadric_collapse_poses_test {
namespace {

using testing::BendingTube;
using testing::TestMesh;

/// One pose in which the second half of the tube is turned by a right angle about its middle.
PosedVertices bent(const BendingTube& tube) {
  PosedVertices posed{{1}, {}};
  const glm::dvec3 middle(0, 0, BendingTube::length / 2);
  const glm::dmat4 there = glm::translate(glm::dmat4(1), middle), back = glm::translate(glm::dmat4(1), -middle);
  const glm::dmat4 turned = there * glm::dmat4(glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0})) * back;
  for (const glm::vec3& at : tube.mesh().positions) {
    const double weight = tube.weight(at);
    posed.maps.push_back(glm::dmat4x3(glm::dmat4(1) * (1 - weight) + turned * weight));
  }
  return posed;
}

TestMesh in_pose(TestMesh mesh, const PosedVertices& posed, std::size_t pose = 0) {
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] = glm::vec3(posed.of(v)[pose] * glm::dvec4(mesh.positions[v], 1));
  }
  return mesh;
}

struct Left {
  TestMesh mesh;
  PosedVertices posed;  ///< of what is left: maps are blended as joint weights are
};

Left coarse(const TestMesh& mesh, const PosedVertices& posed, std::size_t triangles, QuadricCollapseOptions options) {
  options.least = triangles;
  const CollapseSequence sequence = quadric_collapse(mesh.positions, mesh.indices, options, {}, {}, posed);
  Left left{testing::coarse(mesh, sequence, triangles), posed};
  for (std::size_t k = 0; k < sequence.collapses.size(); ++k) {
    for (std::uint32_t i = sequence.first_pair[k]; i < sequence.first_pair[k + 1]; ++i) {
      glm::dmat4x3& kept = left.posed.maps[sequence.pairs[i].kept];
      kept += (left.posed.maps[sequence.pairs[i].removed] - kept) * double{sequence.collapses[k].blend};
    }
  }
  return left;
}

/// Along the axis a straight tube is flat, so at rest its rings cost nothing. Bent it needs some in the middle: many of
/// a bow, the two beside a fold.
TEST(QuadricCollapsePoses, RingsStayWhereATubeBends) {
  for (const BendingTube& tube : {BendingTube{}, BendingTube{.bend = 0.05f}}) {
    const TestMesh mesh = tube.mesh();
    const PosedVertices posed = bent(tube);
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      const auto distance = [&](double weight) {
        const Left left = coarse(mesh, posed, 400, {.placement = placement, .poses = weight});
        EXPECT_EQ(left.mesh.indices.size() / 3, 400u);
        return testing::distance(in_pose(mesh, posed), in_pose(left.mesh, left.posed));
      };
      const double blind = distance(0), seen = distance(1);
      EXPECT_LT(seen, tube.bend < 1 ? 1e-4 : 0.05);
      EXPECT_GT(blind, 5 * seen);
    }
  }
}

TEST(QuadricCollapsePoses, RestCountsBesideThem) {
  const TestMesh tube = BendingTube{}.mesh();
  const auto distance = [&](double weight) {
    return testing::distance(tube, coarse(tube, bent(BendingTube{}), 400, {.poses = weight}).mesh);
  };
  EXPECT_LT(distance(1), 0.05);
  EXPECT_LT(distance(1), 0.5 * distance(1000));
}

/// A pose that turns and moves all alike is the same surface again.
TEST(QuadricCollapsePoses, APoseOfAllAlikeChangesNothing) {
  const TestMesh torus = testing::closed_torus(64, 32);
  const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1), {30, 0, -7}), 1.0, glm::dvec3(0.36, 0.48, 0.8));
  const PosedVertices posed{{1}, std::vector<glm::dmat4x3>(torus.positions.size(), glm::dmat4x3(turned))};
  const auto distance = [&](double weight) {
    return testing::distance(torus, coarse(torus, posed, 300, {.deviation = 0, .poses = weight}).mesh);
  };
  EXPECT_NEAR(distance(1) / distance(0), 1, 0.05);
}

/// What no number can hold says nothing, rather than that all is free.
TEST(QuadricCollapsePoses, AVertexThatFliesOffDoesNoHarm) {
  const TestMesh torus = testing::closed_torus(64, 32);
  PosedVertices posed{{1}, std::vector<glm::dmat4x3>(torus.positions.size(), glm::dmat4x3(1))};
  const auto distance = [&] { return testing::distance(torus, coarse(torus, posed, 300, {}).mesh); };
  const double want = distance();
  posed.maps[5] *= 1e200;
  EXPECT_LT(distance(), 1.2 * want);
}

/// Of which each vertex is moved in another way.
PosedVertices wild(const TestMesh& mesh, std::size_t poses, double largest) {
  Random random(11);
  PosedVertices posed;
  posed.weights.resize(poses, 1.0 / static_cast<double>(poses));
  for (std::size_t i = 0; i < poses * mesh.positions.size(); ++i) {
    glm::dmat4x3 map(0);
    for (int k = 0; k < 4 && i % 7 != 3; ++k) {
      for (int r = 0; r < 3; ++r) map[k][r] = (random.unit() - 0.5) * (i % 5 == 0 ? largest : 1);
    }
    posed.maps.push_back(map);
  }
  return posed;
}

TEST(QuadricCollapsePoses, OddMeshesAndWildPosesRun) {
  std::vector<TestMesh> meshes = testing::odd_meshes();
  meshes.push_back(testing::box_of_sides(6));
  for (const TestMesh& mesh : meshes) {
    for (const double largest : {1e3, 1e38, 1e200}) {
      for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
        const CollapseSequence sequence =
            quadric_collapse(mesh.positions, mesh.indices, {.placement = placement}, {}, {}, wild(mesh, 2, largest));
        EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
      }
    }
  }
}

TEST(QuadricCollapsePoses, DoNotDependOnWhoWorksOnWhichPieceWhen) {
  const BendingTube bending{.around = 64, .along = 200};
  const TestMesh tube = bending.mesh();
  const PosedVertices posed = bent(bending);
  const auto collapses = [&](const Executor* executor) {
    return quadric_collapse(tube.positions, tube.indices, {.executor = executor}, {}, {}, posed);
  };
  const CollapseSequence want = collapses(nullptr);
  EXPECT_EQ(replay(want, tube.positions, tube.indices).mistake, "");
  const Executor backwards(2, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    while (count > 0) task(--count);
  });
  const Executor two(2);
  for (const Executor* executor : {&two, &backwards}) EXPECT_EQ(collapses(executor), want);
}

/// What is claimed is a distance at rest: poses do not add to it.
TEST(QuadricCollapsePoses, ErrorsAreDistancesAtRest) {
  const TestMesh tube = BendingTube{}.mesh();
  const CollapseSequence sequence =
      quadric_collapse(tube.positions, tube.indices, {.poses = 100, .least = 600}, {}, {}, bent(BendingTube{}));
  const double farthest = testing::distance(tube, testing::coarse(tube, sequence, 600));
  EXPECT_LT(sequence.collapses.back().error, farthest);
  EXPECT_GT(sequence.collapses.back().error, farthest / 20);
}

CollapseSequence answered(Scene scene, const Poses& poses, const Settings& settings) {
  testing::RunFixture fixture;
  Run run{fixture.analyses, fixture.executor, fixture.findings, fixture.views, poses};
  const Technique technique = quadric_collapse_plugin().create(settings);
  std::get<std::unique_ptr<Processor>>(technique)->process(scene, {0}, run);
  return *scene.products.find<CollapseSequences>()->meshes.at(0).sequence;
}

/// In four of the run's poses, if an animation bends it; else poses change not a bit.
TEST(QuadricCollapsePlugin, LooksAtPosesOfWhatMoves) {
  Scene scene = BendingTube{}.scene();
  const Poses poses = make_poses(scene, {});
  Analyses analyses;
  const std::vector<DrawId> draws{0};
  const JoinedMesh mesh = *joined_mesh(scene, draws, analyses);
  const PosedVertices posed = mesh_in_poses({mesh, scene, draws}, poses, 4);
  AttributeWeights weights;
  weights.joints /= 4;
  const std::size_t least = mesh.indices.size() / 300 + 1;
  const CollapseSequence want =
      quadric_collapse(mesh.positions, mesh.indices, {.least = least}, attribute_rows(mesh, weights), mesh.part, posed);
  const CollapseSequence at_rest = answered(scene, poses, {{"poses", 0.0}});
  EXPECT_EQ(answered(scene, poses, {}), want);
  EXPECT_NE(want, at_rest);
  EXPECT_EQ(answered(scene, rest_pose, {}), at_rest);
  scene.draws[0].traits.remove(traits::animated);
  EXPECT_EQ(answered(scene, poses, {}), at_rest);
}

}  // namespace
}  // namespace foredraw::quadric_collapse_poses_test
