#include <foredraw/measuring/mesh_in_poses.h>

#include "support/bending_tube.h"

#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <limits>

namespace foredraw::mesh_in_poses_test {
namespace {

using testing::BendingTube;

PosedVertices in_poses(const Scene& scene, const Poses& poses, std::size_t most = 4) {
  Analyses analyses;
  const std::vector<DrawId> draws{0};
  const JoinedMesh mesh = *joined_mesh(scene, draws, analyses);
  return mesh_in_poses({mesh, scene, draws}, poses, most);
}

/// A pose of a clip that lasts a second, at the middles of equal parts of it.
double time_of(std::size_t pose, std::size_t count) {
  return (static_cast<double>(pose) + 0.5) / static_cast<double>(count);
}

double length_of_edge(const glm::dmat4x3& a, glm::vec3 from, const glm::dmat4x3& b, glm::vec3 to) {
  return glm::length(a * glm::dvec4(from, 1) - b * glm::dvec4(to, 1));
}

/// In the middles of as many parts of the poses, and like positions in them but for one factor.
TEST(MeshInPoses, MovesVerticesAsPosesDo) {
  const Scene scene = BendingTube{}.scene();
  const std::vector<glm::vec3> rest = BendingTube{}.mesh().positions;
  const PosedVertices posed = in_poses(scene, make_poses(scene, {.poses = "16"}));
  ASSERT_EQ(posed.poses(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(posed.weights[i], 0.25);
    const Pose pose{AnimationId{0}, time_of(4 * i + 2, 16)};
    const std::vector<glm::vec3> want = posed_positions(scene, {0, NodeId{0}}, posed_nodes(scene, pose));
    const auto at = [&](std::uint32_t v) { return posed.of(v)[i] * glm::dvec4(rest[v], 1); };
    const double scale = glm::length(at(0)) / glm::length(glm::dvec3(want[0]));
    EXPECT_NEAR(scale, 1, 0.05) << "the tube shrinks where it bends";
    for (std::uint32_t v = 0; v < rest.size(); ++v) {
      EXPECT_LT(glm::length(at(v) - scale * glm::dvec3(want[v])), 1e-5) << v;
    }
  }
}

/// How large the world shows it does not matter: the surface is as large as at rest.
TEST(MeshInPoses, IsAsLargeAsAtRest) {
  const std::vector<glm::vec3> rest = BendingTube{}.mesh().positions;
  const Scene same = BendingTube{}.scene(), large = BendingTube{}.scene(64);
  const PosedVertices a = in_poses(same, make_poses(same, {})), b = in_poses(large, make_poses(large, {}));
  for (std::uint32_t v = 1; v < rest.size(); ++v) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double want = length_of_edge(a.of(0)[i], rest[0], a.of(v)[i], rest[v]);
      EXPECT_NEAR(length_of_edge(b.of(0)[i], rest[0], b.of(v)[i], rest[v]), want, 1e-5);
    }
  }
  EXPECT_NEAR(length_of_edge(a.of(0)[0], rest[0], a.of(12)[0], rest[12]), 2, 0.1) << "across its foot";
}

TEST(MeshInPoses, CountsPosesByTheirWeights) {
  const Scene scene = BendingTube{}.scene();
  Poses poses{{Pose{AnimationId{0}, 0, 0.5}, Pose{AnimationId{0}, 0.5, 7}, Pose{AnimationId{0}, 1, 0.5}}};
  EXPECT_EQ(in_poses(scene, poses).weights, (std::vector<double>{1}));
  poses.poses[2].weight = 8.5;
  EXPECT_EQ(in_poses(scene, poses).weights, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(in_poses(scene, poses, 32).weights, (std::vector<double>{1 / 32.0, 14 / 32.0, 17 / 32.0}));
  EXPECT_EQ(in_poses(scene, poses, 1).weights, (std::vector<double>{1}));
}

TEST(MeshInPoses, AreNoneOfWhatDoesNotMove) {
  const Scene scene = BendingTube{}.scene();
  const Poses poses = make_poses(scene, {});
  EXPECT_EQ(in_poses(scene, poses).poses(), 4u);
  EXPECT_EQ(in_poses(scene, rest_pose).poses(), 0u);
  EXPECT_EQ(in_poses(scene, poses, 0).poses(), 0u);
  Scene standing = scene;
  standing.draws[0].traits.remove(traits::animated);
  EXPECT_EQ(in_poses(standing, poses).poses(), 0u);
  Scene hidden = scene;
  hidden.nodes[0].is_shown = false;
  EXPECT_EQ(in_poses(hidden, poses).poses(), 0u);
}

TEST(MeshInPoses, AreNoneWhereNothingIsFiniteOrLarge) {
  Scene scene = BendingTube{}.scene();
  const Poses poses = make_poses(scene, {});
  scene.nodes[3].transform.scale = glm::vec3(0);
  EXPECT_EQ(in_poses(scene, poses).poses(), 0u);
  for (const float size : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    scene.nodes[3].transform.scale = glm::vec3(size);
    EXPECT_EQ(in_poses(scene, poses).poses(), 0u) << size;
  }
}

}  // namespace
}  // namespace foredraw::mesh_in_poses_test
