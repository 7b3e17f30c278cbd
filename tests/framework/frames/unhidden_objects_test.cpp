#include <foredraw/frames/unhidden_objects.h>

#include "support/levelled_field.h"

#include <gtest/gtest.h>

namespace foredraw::unhidden_objects_test {
namespace {

/// A wall of that material between the camera and three spheres, of which the third is beside it.
Scene behind_a_wall(AlphaMode mode = AlphaMode::opaque) {
  Scene scene =
      testing::scene_of({testing::draw_of({{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {0, 1, 2, 0, 2, 3}}),
                         testing::draw_of(testing::sphere(16, 8))});
  Material material;
  material.alpha_mode = mode;
  scene.materials.push_back(material);
  scene.draws[0].material = 0;
  scene.nodes.resize(4);
  const glm::vec3 places[] = {{0, 0, -10}, {0, 0, -15}, {3, 2, -30}, {9, 0, -15}};
  for (std::size_t i = 0; i < 4; ++i) {
    scene.nodes[i].mesh = i == 0 ? 0 : 1;
    scene.nodes[i].transform.translation = places[i];
  }
  return scene;
}

std::vector<std::uint32_t> unhidden(const Scene& scene) {
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  constexpr FrameSize size{320, 180};
  std::vector<std::uint32_t> objects;
  for (const SeenObject& seen : unhidden_objects(frames, moment, {}, size, seen_objects(frames, moment, {}, size))) {
    objects.push_back(seen.object);
  }
  return objects;
}

TEST(UnhiddenObjects, WhatStandsBehindAWallIsHidden) {
  EXPECT_EQ(unhidden(behind_a_wall()), (std::vector<std::uint32_t>{0, 3}));
}

TEST(UnhiddenObjects, WhatLetsThroughHidesNothing) {
  EXPECT_EQ(unhidden(behind_a_wall(AlphaMode::blend)).size(), 4u);
  EXPECT_EQ(unhidden(behind_a_wall(AlphaMode::mask)).size(), 4u);
}

TEST(UnhiddenObjects, WhatReachesOutIsNotHidden) {
  Scene scene = behind_a_wall();
  scene.nodes[1].transform.translation = {7.4f, 0, -15};  // the wall ends at 7.5 there
  EXPECT_EQ(unhidden(scene).size(), 3u);
}

/// The wall is 10 units high before a picture that shows 11.5 there, in the middle of 320 x 180.
TEST(UnhiddenObjects, KnowHowManyPixelsShow) {
  const Scene scene = behind_a_wall();
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  constexpr FrameSize size{320, 180};
  const auto seen = unhidden_objects(frames, moment, {}, size, seen_objects(frames, moment, {}, size));
  EXPECT_NEAR(seen[0].shown, 155.9 * 155.9, 700);
  const double radius = 180 / (2 * 0.57735 * 15);
  EXPECT_NEAR(seen[1].shown, 3.14159 * radius * radius, 0.3 * 3.14159 * radius * radius);
}

TEST(UnhiddenObjects, AnObjectDoesNotHideItself) {
  Scene scene = behind_a_wall();
  scene.nodes.erase(scene.nodes.begin());
  EXPECT_EQ(unhidden(scene).size(), 3u);
}

}  // namespace
}  // namespace foredraw::unhidden_objects_test
