#include <foredraw/viewing/distinct_poses.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::distinct_poses_test {
namespace {

/// A triangle that hangs below the joint of a skin, so that its node matters, and a clip that moves it from 0 to 1 and
/// back within 2 seconds.
Scene moved_triangle() {
  Scene scene = testing::scene_of(testing::TestMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}});
  scene.skins.resize(1);
  scene.skins[0].joints = {0};
  scene.animations.resize(1);
  scene.animations[0].channels.push_back({0, AnimatedPath::translation, Interpolation::linear, Shared<float>({0, 1, 2}),
                                          Shared<float>({0, 0, 0, 1, 0, 0, 0, 0, 0})});
  return scene;
}

DistinctPoses distinct(const Scene& scene, const Poses& poses, int threads = 2) {
  return distinct_poses(scene, subjects_of(scene), poses, Executor(threads))[0];
}

using Numbers = std::vector<std::size_t>;
using Weights = std::vector<double>;

TEST(DistinctPoses, equal_ones_are_found_and_their_weights_added) {
  const Scene scene = moved_triangle();
  const Poses poses{{{}, {0, 0.5}, {0, 0, 3}, {0, 1.5, 2}, {0, 1}, {0, 9}}};
  for (const int threads : {1, 4}) {
    const DistinctPoses found = distinct(scene, poses, threads);
    EXPECT_EQ(found.first_alike, (Numbers{0, 1, 0, 1, 4, 0}));
    EXPECT_EQ(found.weights, (Weights{5, 3, 0, 0, 1, 0}));
  }
}

TEST(DistinctPoses, different_ones_are_counted_over_all_subjects) {
  const std::vector<DistinctPoses> both = {{{0, 1, 0, 1}, {}}, {{0, 0, 2, 0}, {}}};
  EXPECT_EQ(count_different(std::span(both).first(1)), 2u);
  EXPECT_EQ(count_different(both), 3u);
  EXPECT_EQ(count_different({}), 0u);
}

TEST(DistinctPoses, what_is_in_its_own_space_never_moves) {
  Scene scene = moved_triangle();
  scene.skins.clear();
  const DistinctPoses found = distinct(scene, {{{}, {0, 0.5}, {0, 1}}});
  EXPECT_EQ(found.first_alike, (Numbers{0, 0, 0}));
  EXPECT_EQ(found.weights, (Weights{3, 0, 0}));
}

TEST(DistinctPoses, faces_that_turn_the_other_way_look_different) {
  Scene scene = moved_triangle();
  // Positions all 0, mirrored or not.
  scene.draws[0].levels[0].vertices = testing::vertex_streams({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  scene.animations[0].channels[0] = {0, AnimatedPath::scale, Interpolation::linear, Shared<float>({0, 1}),
                                     Shared<float>({1, 1, 1, -1, 1, 1})};
  EXPECT_EQ(distinct(scene, {{{}, {0, 1}}}).first_alike, (Numbers{0, 1}));
}

TEST(DistinctPoses, one_pose_is_itself) {
  EXPECT_EQ(distinct(moved_triangle(), rest_pose).first_alike, Numbers{0});
  EXPECT_EQ(distinct(moved_triangle(), rest_pose).weights, Weights{1});
}

}  // namespace
}  // namespace foredraw::distinct_poses_test
