// FOREDRAW_seam_heights: made by the stage, moved with the triangles, written, read, and what it does for a surface.
#include "plugins/processors/displacement_seams/seam_heights_product.h"

#include "support/displaced.h"
#include "support/staged.h"
#include "support/uv_charts.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace foredraw::displacement_seams_files_test {
namespace {

using namespace testing;

Scene charts_on_noise(int squares = 2) {
  const Charts charts = cube_sphere(squares, turned_places());
  const testing::Map map = noise_map(96, 96, 1);
  Image image = height_image(96, 96, [&](auto x, auto y) { return map.texels[std::size_t{y} * 96 + x]; });
  return displaced_scene({charts.positions, charts.indices}, charts.uvs, std::move(image), 0.2f);
}

/// Edges of triangles that no other one has the other way round, by places.
std::size_t open_edges(const Draw& draw) {
  const auto at = decode_vec3(*draw.full().vertices->find("POSITION"));
  const auto indices = draw.full().stream().indices.view();
  std::map<std::array<Point, 2>, int> edges;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Point a = point_of(at[indices[i]]), b = point_of(at[indices[i % 3 == 2 ? i - 2 : i + 1]]);
    if (a < b) ++edges[{a, b}];
    if (b < a) --edges[{b, a}];
  }
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
}

std::vector<std::byte> written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {seam_heights_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

TEST(SeamHeights, CloseTheSurfaceAtAnyLevelInEverySpacing) {
  const Scene repaired = run("displacement-seams", charts_on_noise(1)).scene;
  const Scene stored = run("displacement-seams(table=true)", charts_on_noise(1)).scene;
  ASSERT_NE(seams_of(stored, 0), nullptr);
  for (const char* spacing : {"equal", "fractional-odd", "fractional-even"}) {
    for (const char* parts : {"3", "5.5", "64"}) {
      const std::string stage = std::string("tessellate(parts=") + parts + ", spacing=" + spacing + ')';
      EXPECT_EQ(open_edges(run(stage, stored).scene.draws[0]), 0u) << stage;
    }
  }
  EXPECT_GT(open_edges(run("tessellate(parts=5.5)", repaired).scene.draws[0]), 10u) << "the map alone does not";
}

TEST(SeamHeights, ComeBackFromFilesAndMoveWithTheTriangles) {
  const Result result = run("displacement-seams(table=true), tipsify, vertex-fetch", charts_on_noise());
  ASSERT_FALSE(result.failed);
  Diagnostics diagnostics;
  const auto again = read_gltf(written(result.scene), "again", {}, diagnostics, {.products = {seam_heights_product()}});
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  ASSERT_NE(seams_of(*again, 0), nullptr);
  EXPECT_EQ(*again->products.find<SeamHeights>(), *result.scene.products.find<SeamHeights>());
  EXPECT_EQ(open_edges(run("tessellate(parts=7)", result.scene).scene.draws[0]), 0u) << "sides follow their triangles";
}

TEST(SeamHeights, GoWithTheirMap) {
  const Scene stored = run("displacement-seams(table=true)", charts_on_noise()).scene;
  EXPECT_NE(seams_of(run("displacement(factor=2)", stored).scene, 0), nullptr) << "they are parts of the range";
  EXPECT_EQ(run("tessellate(parts=2)", stored).scene.products.find<SeamHeights>(), nullptr);
  const Scene many = run("displacement-seams(table=true)", charts_on_noise(4)).scene;
  EXPECT_EQ(run("quadric-collapse, simplify(ratio=0.5)", many).scene.products.find<SeamHeights>(), nullptr)
      << "of triangles that are others";
}

TEST(SeamHeights, AreStoredOnceForDrawsOfOneMap) {
  Scene scene = charts_on_noise();
  const auto indices = scene.draws[0].full().stream().indices.view();
  const std::ptrdiff_t half = static_cast<std::ptrdiff_t>(indices.size() / 6 * 3);
  scene.draws.push_back(scene.draws[0]);
  scene.draws[0].full().stream().indices = Shared(std::vector(indices.begin(), indices.begin() + half));
  scene.draws[1].full().stream().indices = Shared(std::vector(indices.begin() + half, indices.end()));
  scene.meshes[0].draws.push_back(1);
  const Scene stored = run("displacement-seams(table=true)", scene).scene;
  const DrawSeams *one = seams_of(stored, 0), *other = seams_of(stored, 1);
  ASSERT_TRUE(one && other);
  EXPECT_TRUE(one->heights.is(other->heights));
  EXPECT_EQ(one->sides.size() + other->sides.size(), 2 * one->parts_log2.size());
  const Scene made = run("tessellate(parts=9, spacing=fractional-even)", stored).scene;
  Draw both = made.draws[0];
  const auto at = decode_vec3(*made.draws[1].full().vertices->find("POSITION"));
  auto positions = decode_vec3(*both.full().vertices->find("POSITION"));
  const auto first = static_cast<std::uint32_t>(positions.size());
  positions.insert(positions.end(), at.begin(), at.end());
  const auto of_one = both.full().stream().indices.view(), of_other = made.draws[1].full().stream().indices.view();
  std::vector<std::uint32_t> all(of_one.begin(), of_one.end());
  for (const std::uint32_t v : of_other) all.push_back(first + v);
  EXPECT_EQ(open_edges(triangle_draw("both", positions, all)), 0u);
}

}  // namespace
}  // namespace foredraw::displacement_seams_files_test
