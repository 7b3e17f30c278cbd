#include <foredraw/viewing/shown_scene.h>

#include "support/displaced.h"

#include <foredraw/viewing/displaced_draw.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::shown_scene_test {
namespace {

Image high(std::uint32_t size) {
  return testing::height_image(size, size, [](auto x, auto) { return static_cast<std::uint16_t>(1000 * x); });
}

TEST(ShownScene, HasTheTrianglesThatTheMapMoves) {
  Scene scene = testing::displaced_grid(2, 2, high(16), 3);
  scene.draws[0].levels.push_back(scene.draws[0].full());
  Analyses analyses;
  const auto shown = shown_scene(scene, analyses);
  ASSERT_TRUE(shown);
  const auto displaced = displaced_draw_of(scene, 0, analyses);
  const Level& level = shown->draws[0].full();
  EXPECT_TRUE(std::ranges::equal(level.stream().indices.view(), displaced->mesh.indices));
  EXPECT_EQ(decode_vec3(*level.vertices->find("POSITION")),
            displaced_positions(displaced->mesh, scene.draws[0].full().stream().indices.view(),
                                decode_vec3(*scene.draws[0].full().vertices->find("POSITION")), displaced->directions,
                                displaced->displacements));
  EXPECT_NE(level.vertices->find("TEXCOORD_0"), nullptr);
  EXPECT_EQ(shown->draws[0].levels[1].vertices, scene.draws[0].full().vertices) << "coarser levels stay";
  EXPECT_EQ(scene.draws[0].full().stream().triangle_count(), 8u);
}

TEST(ShownScene, IsNoneWhereNothingMoves) {
  Analyses analyses;
  EXPECT_FALSE(shown_scene(testing::scene_of(testing::grid(2, 2)), analyses));
  Scene unreadable = testing::displaced_grid(2, 2, high(16), 3);
  unreadable.images[0] = Image{.name = "lost", .uri = "lost.png"};
  EXPECT_FALSE(shown_scene(unreadable, analyses));
}

}  // namespace
}  // namespace foredraw::shown_scene_test
