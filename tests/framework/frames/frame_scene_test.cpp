#include <foredraw/frames/frame_scene.h>

#include "support/displaced.h"

#include <gtest/gtest.h>

namespace foredraw::frame_scene_test {
namespace {

TEST(FrameScene, ShowsDisplacedDrawsMovedAndCoarserLevelsAsTheyAre) {
  const auto flat = testing::height_image(16, 16, [](auto, auto) { return 65535; });
  Scene scene = testing::displaced_grid(2, 2, flat, 3);
  scene.draws[0].levels.push_back(scene.draws[0].full());
  Analyses analyses;
  const FrameScene frames(scene, analyses, Executor(1));
  const FrameMesh& mesh = frames.mesh_of(0);
  EXPECT_NEAR(mesh.sphere.centre.z, 3, 1e-5);
  const FrameLevel &full = mesh.draws[0].levels[0], &coarser = mesh.draws[0].levels[1];
  EXPECT_GT(full.indices.size(), 3u * 8 * 4);
  for (const glm::vec3& p : full.positions->values) EXPECT_EQ(p.z, 3);
  EXPECT_EQ(coarser.indices.size(), 3u * 8);
  for (const glm::vec3& p : coarser.positions->values) EXPECT_EQ(p.z, 0);
}

}  // namespace
}  // namespace foredraw::frame_scene_test
