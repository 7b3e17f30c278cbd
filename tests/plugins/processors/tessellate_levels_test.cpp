// The divided surface as levels of detail: each with half as many parts to an edge as the one before.
#include "plugins/processors/tessellate/coarser_levels.h"

#include "support/displaced.h"
#include "support/products.h"
#include "support/staged.h"

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace foredraw::tessellate_levels_test {
namespace {

using Place = std::tuple<float, float, float>;
using Corners = std::array<Place, 3>;

Image hill(std::uint32_t size) {
  return testing::height_image(size, size, [&](std::uint32_t x, std::uint32_t y) {
    const double u = (x + 0.5) / size - 0.5, v = (y + 0.5) / size - 0.5;
    return static_cast<std::uint16_t>(65535 * std::max(0.0, 1 - 8 * std::sqrt(u * u + v * v)));
  });
}

/// Three places a triangle, in the sequence of the level.
std::vector<Corners> triangles_of(const Level& level) {
  const std::vector<glm::vec3> at = decode_vec3(*level.vertices->find("POSITION"));
  const auto indices = level.stream().indices.view();
  std::vector<Corners> all(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i)
    all[i / 3][i % 3] = {at[indices[i]].x, at[indices[i]].y, at[indices[i]].z};
  return all;
}

std::size_t open_edges(const Level& level) {
  std::map<std::pair<Place, Place>, int> edges;
  for (const Corners& of : triangles_of(level)) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Place &a = of[c], &b = of[(c + 1) % 3];
      if (a < b) ++edges[{a, b}];
      if (b < a) --edges[{b, a}];
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
}

TEST(TessellateLevels, AreTheSameSurfaceInHalfAsManyParts) {
  const Scene scene = testing::displaced_grid(4, 4, hill(64), 2);
  const Result result = testing::run("tessellate(levels=3)", scene);
  ASSERT_FALSE(result.failed);
  const Draw& draw = result.scene.draws[0];
  ASSERT_EQ(draw.levels.size(), 3u);
  for (std::size_t l = 0; l < 3; ++l) {
    const std::string parts = std::to_string(8 >> l);
    const Scene alone = testing::run("tessellate(parts=" + parts + ")", scene).scene;
    EXPECT_EQ(triangles_of(draw.levels[l]), triangles_of(alone.draws[0].full())) << parts;
    EXPECT_TRUE(draw.levels[l].vertices == draw.full().vertices) << "its points are among those of full detail";
  }
}

TEST(TessellateLevels, HaveErrorsThatAreProved) {
  const Result result = testing::run("tessellate(levels=4)", testing::displaced_grid(4, 4, hill(64), 2));
  const Draw& draw = result.scene.draws[0];
  ASSERT_EQ(draw.levels.size(), 4u);
  const auto at = decode_vec3(*draw.full().vertices->find("POSITION"));
  const Executor executor(2);
  for (std::size_t l = 1; l < 4; ++l) {
    const Level& level = draw.levels[l];
    EXPECT_GE(level.error, draw.levels[l - 1].error);
    const auto found = surface_distance({at, draw.full().stream().indices.view()}, {at, level.stream().indices.view()},
                                        {.samples = 20'000, .seed = 7}, executor);
    EXPECT_GT(found->largest, 0);
    EXPECT_LE(found->largest, level.error);
    EXPECT_LE(level.error, 1.25 * found->largest + 1e-3) << "and no bound that says nothing";
  }
}

TEST(TessellateLevels, HaveVerticesOfTheirOwnWherePartsAreNoPowersOfTwo) {
  const Scene scene = testing::displaced_grid(2, 2, hill(64), 2);
  for (const char* spacing : {"equal", "fractional-odd", "fractional-even"}) {
    const std::string options = ", spacing='" + std::string(spacing) + "'";
    const Scene made = testing::run("tessellate(parts=15, levels=3" + options + ")", scene).scene;
    ASSERT_EQ(made.draws[0].levels.size(), 3u) << spacing;
    const Scene half = testing::run("tessellate(parts=7.5" + options + ")", scene).scene;
    EXPECT_EQ(triangles_of(made.draws[0].levels[1]), triangles_of(half.draws[0].full())) << spacing;
    EXPECT_FALSE(made.draws[0].levels[1].vertices == made.draws[0].full().vertices);
  }
}

TEST(TessellateLevels, AreClosedWhereTheCageIs) {
  testing::TestMesh sphere = testing::sphere(12, 8);
  for (glm::vec3& p : sphere.positions) p = glm::round(p * 1024.0f) / 1024.0f;  // it closes to the bit
  std::vector<glm::vec2> uv;
  for (const glm::vec3& p : sphere.positions) uv.emplace_back(0.5f + 0.4f * p.x, 0.5f + 0.4f * p.y);
  const Scene scene = testing::displaced_scene(sphere, uv, hill(256), 0.2f);
  for (const char* stages : {"tessellate(texels=4, levels=4)", "tessellation-levels, tessellate(levels=4)",
                             "tessellate(parts=11, spacing=fractional-odd, levels=4)"}) {
    const Scene made = testing::run(stages, scene).scene;
    ASSERT_EQ(made.draws[0].levels.size(), 4u) << stages;
    for (const Level& level : made.draws[0].levels) EXPECT_EQ(open_edges(level), 0u) << stages;
  }
}

TEST(TessellateLevels, OfBakedHeightsUseTheirVertices) {
  Scene scene = testing::scene_of(testing::grid(2, 2));
  BakedHeights baked;
  const std::vector<std::uint8_t> logs = {3, 2, 0, 1, 2, 2, 1, 3};
  DrawHeights heights{
      .draw = 0, .levels = Shared(std::vector(logs)), .heights = {}, .bits = 16, .factor = 0.5f, .offset = 0};
  const std::size_t points = tessellated_mesh(heights, scene.draws[0].full()).vertices();
  std::vector<std::uint16_t> some(points);
  for (std::size_t i = 0; i < points; ++i) some[i] = static_cast<std::uint16_t>(i * 7919 % 65536);
  heights.heights = Shared(some);
  baked.draws.push_back(heights);
  scene.products.set(baked);
  scene.draws[0].traits.add(traits::displaced);
  const Result result = testing::run("tessellate(levels=7)", scene);
  const Draw& draw = result.scene.draws[0];
  ASSERT_EQ(draw.levels.size(), 4u) << "8, 4, 2 parts, 1 part";
  for (const Level& level : draw.levels) EXPECT_TRUE(level.vertices == draw.full().vertices);
  EXPECT_EQ(draw.levels.back().stream().triangle_count(), 8u);
}

TEST(TessellateLevels, StopWhereNoEdgeHasTwoParts) {
  const Scene scene = testing::displaced_grid(2, 2, hill(16), 2);
  const Result one = testing::run("tessellate(parts=1, levels=3)", scene);
  EXPECT_EQ(one.scene.draws[0].levels.size(), 1u);
  EXPECT_FALSE(one.scene.draws[0].traits.has(traits::displaced)) << "its corners have moved all the same";
  EXPECT_EQ(testing::run("tessellate(parts=2, levels=7)", scene).scene.draws[0].levels.size(), 2u);
}

TEST(TessellateLevels, OfOneSubjectAreAsMany) {
  Scene scene = testing::displaced_grid(2, 2, hill(64), 2);
  scene.draws.push_back(scene.draws[0]);
  scene.images.push_back(hill(8));
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].displacement->texture.image = 1;
  scene.draws[1].material = 1;
  scene.meshes[0].draws.push_back(1);
  const Scene made = testing::run("tessellate(levels=7)", scene).scene;
  ASSERT_EQ(made.draws[0].levels.size(), 5u) << "16, 8, 4, 2 parts, 1 part";
  ASSERT_EQ(made.draws[1].levels.size(), 5u);
  EXPECT_TRUE(made.draws[1].levels[4].stream().indices == made.draws[1].levels[1].stream().indices)
      << "2 parts, 1 part";
}

TEST(TessellateLevels, GoThroughFiles) {
  const Result result =
      testing::run("tessellate(levels=3), weld, tipsify, vertex-fetch", testing::displaced_grid(4, 4, hill(64), 2));
  ASSERT_FALSE(result.failed);
  Diagnostics diagnostics;
  const auto files = encode_gltf(result.scene, "out.glb", diagnostics, {.products = testing::built_in_products()});
  const auto again =
      read_gltf(files.value().front().bytes, "out.glb", {}, diagnostics, {.products = testing::built_in_products()});
  ASSERT_TRUE(again) << to_text(diagnostics);
  ASSERT_EQ(again->draws[0].levels.size(), 3u);
  for (std::size_t l = 0; l < 3; ++l)
    EXPECT_EQ(triangles_of(again->draws[0].levels[l]), triangles_of(result.scene.draws[0].levels[l]));
}

}  // namespace
}  // namespace foredraw::tessellate_levels_test
