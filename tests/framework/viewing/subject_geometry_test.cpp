#include <foredraw/viewing/subject_geometry.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw {
namespace {

using testing::TestMesh;

const TestMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};

SubjectGeometry drawn(const Scene& scene, Faces faces = Faces::material) {
  Analyses analyses;
  return subject_geometry(scene, subjects_of(scene)[0], faces, posed_nodes(scene), analyses);
}

/// One mesh of two draws.
Scene two_draws() {
  Scene scene = testing::scene_of({testing::draw_of(triangle), testing::draw_of(triangle)});
  scene.meshes[0].draws = {0, 1};
  scene.meshes.pop_back();
  scene.nodes.pop_back();
  return scene;
}

TEST(SubjectGeometry, what_is_not_drawn_has_no_triangles) {
  Scene scene = two_draws();
  scene.materials.resize(1);
  scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.draws[0].material = 0;
  EXPECT_TRUE(drawn(scene).parts[0].indices.empty());
  EXPECT_EQ(drawn(scene).parts[1].indices.size(), 3u);
  scene.draws[1].topology = Topology::lines;
  EXPECT_TRUE(drawn(scene).parts[1].indices.empty());
}

TEST(SubjectGeometry, back_faces_are_drawn_where_the_material_says_so_unless_front_faces_are_asked_for) {
  Scene scene = two_draws();
  scene.materials.resize(1);
  scene.materials[0].double_sided = true;
  scene.draws[1].material = 0;
  EXPECT_TRUE(drawn(scene).parts[0].culls_back_faces);
  EXPECT_FALSE(drawn(scene).parts[1].culls_back_faces);
  EXPECT_TRUE(drawn(scene, Faces::front).parts[1].culls_back_faces);
}

TEST(SubjectGeometry, triangles_with_a_position_that_is_not_finite_are_counted_once) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {nan, 1, 0}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3, 0, 1, 0};
  EXPECT_EQ(count_non_finite_triangles({positions, indices}), 2u);
}

}  // namespace
}  // namespace foredraw
