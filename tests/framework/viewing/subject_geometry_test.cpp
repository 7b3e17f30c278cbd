#include <foredraw/viewing/subject_geometry.h>

#include "support/displaced.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace foredraw::subject_geometry_test {
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

/// A map that rises along u from 0 to 1 in the middles of its outer texels.
Image slope(std::uint32_t size) {
  return testing::height_image(size, 1,
                               [&](auto x, auto) { return static_cast<std::uint16_t>(65535 * x / (size - 1)); });
}

TEST(SubjectGeometry, ShowsADisplacedDrawAsItsMapMovesItAndWhoseTrianglesItsAre) {
  const Scene scene = testing::displaced_grid(2, 2, slope(16), 3);
  Analyses analyses;
  const SubjectGeometry shown =
      subject_geometry(scene, subjects_of(scene)[0], Faces::material, posed_nodes(scene), analyses);
  const RasterPart& part = shown.parts[0];
  EXPECT_EQ(part.triangle_count(), 8u);
  ASSERT_EQ(part.owners.size(), part.indices.size() / 3);
  EXPECT_EQ(part.owners.back(), 7u);
  EXPECT_TRUE(std::ranges::is_sorted(part.owners));
  EXPECT_GT(part.owners.size(), 8u * 16) << "8 texels to an edge along u";
  // Within the outer half texels the height is that of the slope.
  int inside = 0;
  for (const glm::vec3& p : part.positions) {
    const float texel = p.x * 8 - 0.5f;
    if (texel < 0 || texel > 15) continue;
    EXPECT_NEAR(p.z, 3 * texel / 15, 0.001f) << p.x;
    ++inside;
  }
  EXPECT_GT(inside, 50);
  for (std::size_t t = 0; t < part.owners.size(); ++t) {
    const auto owner = scene.draws[0].full().stream().indices.view().subspan(3 * part.owners[t], 3);
    glm::vec2 low(9), high(-9), middle(0);
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::vec2 corner(testing::grid(2, 2).positions[owner[c]]);
      low = glm::min(low, corner);
      high = glm::max(high, corner);
      middle += glm::vec2(part.positions[part.indices[3 * t + c]]) / 3.0f;
    }
    EXPECT_TRUE(middle.x >= low.x && middle.x <= high.x && middle.y >= low.y && middle.y <= high.y);
  }
  EXPECT_EQ(prepared(shown.parts)[0].numbers[part.owners.size() - 1], 7u);
}

TEST(SubjectGeometry, ShowsItInThePoseOfItsNode) {
  Scene scene =
      testing::displaced_grid(1, 1, testing::height_image(1, 1, [](auto, auto) { return 65535; }), 0.5f, 0.25f);
  scene.nodes[0].transform.scale = glm::vec3(2);
  scene.nodes[0].transform.translation = {0, 0, 10};
  Analyses analyses;
  const Subject subject{"grid", {{0, NodeId{0}}}};
  const SubjectGeometry shown = subject_geometry(scene, subject, Faces::material, posed_nodes(scene), analyses);
  for (const glm::vec3& p : shown.positions[0]) EXPECT_EQ(p.z, 10 + 2 * 0.75f);
}

TEST(SubjectGeometry, ShowsWhatIsStoredWhereItIsAskedForOrTheMapCannotBeRead) {
  Scene scene = testing::displaced_grid(2, 2, slope(16), 3);
  Analyses analyses;
  const auto part = [&](ShownSurface surface) {
    const SubjectGeometry shown =
        subject_geometry(scene, subjects_of(scene)[0], Faces::material, posed_nodes(scene), analyses, surface);
    EXPECT_EQ(shown.parts[0].triangle_count(), 8u);
    return shown.parts[0].indices.size() / 3;
  };
  EXPECT_EQ(part(ShownSurface::stored), 8u);
  EXPECT_GT(part(ShownSurface::displaced), 8u);
  scene.images[0] = Image{.name = "lost", .uri = "lost.png"};
  EXPECT_EQ(part(ShownSurface::displaced), 8u);
}

}  // namespace
}  // namespace foredraw::subject_geometry_test
