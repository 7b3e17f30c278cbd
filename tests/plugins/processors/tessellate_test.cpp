#include "plugins/processors/tessellate/tessellate.h"

#include "support/displaced.h"
#include "support/staged.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <map>
#include <tuple>

namespace foredraw {
namespace {

/// A sphere of radius 1 whose map is 0 all over but in one hill.
Image hill(std::uint32_t size) {
  return testing::height_image(size, size, [&](std::uint32_t x, std::uint32_t y) {
    const double u = (x + 0.5) / size - 0.5, v = (y + 0.5) / size - 0.5;
    return static_cast<std::uint16_t>(65535 * std::max(0.0, 1 - 8 * std::sqrt(u * u + v * v)));
  });
}

std::vector<glm::vec3> positions_in(const Scene& scene) {
  return decode_vec3(*scene.draws[0].full().vertices->find("POSITION"));
}

TEST(Tessellate, LeavesPlainTrianglesWhereTheMapMovedThem) {
  const Scene scene = testing::displaced_grid(4, 4, hill(64), 2);
  const Result result = testing::run("tessellate", scene);
  const Draw& draw = result.scene.draws[0];
  EXPECT_EQ(draw.full().stream().triangle_count(), 32u * 8 * 8 * 3 / 2)
      << "16 texels to an edge, at least 1.5 to a part";
  float highest = 0;
  for (const glm::vec3& p : positions_in(result.scene)) highest = std::max(highest, p.z);
  EXPECT_NEAR(highest, 2, 0.4);
  EXPECT_FALSE(draw.traits.has(traits::displaced));
  EXPECT_FALSE(result.scene.material_of(draw)->displacement) << "it would be moved twice";
  EXPECT_EQ(draw.full().vertices->find("TEXCOORD_0")->count(), draw.full().vertices->count);
}

TEST(Tessellate, AtLevelOneMovesTheCornersAlone) {
  const Scene scene = testing::displaced_grid(4, 4, hill(64), 2);
  const Result result = testing::run("tessellate(parts=1)", scene);
  EXPECT_TRUE(result.scene.draws[0].full().stream().indices == scene.draws[0].full().stream().indices);
  const auto moved = positions_in(result.scene);
  ASSERT_EQ(moved.size(), 25u);
  EXPECT_NEAR(moved[12].z, 2, 0.3) << "the middle";
  EXPECT_EQ(moved[0], glm::vec3(0));
}

TEST(Tessellate, NormalsAreThoseOfTheMovedSurface) {
  Scene scene = testing::displaced_grid(
      2, 2, testing::height_image(64, 1, [](auto x, auto) { return static_cast<std::uint16_t>(65535 * x / 63); }), 2);
  VertexStreams vertices = *scene.draws[0].full().vertices;
  vertices.base.push_back(testing::float_stream("NORMAL", std::vector<glm::vec3>(9, {0, 0, 1})));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(vertices);
  const auto normals = [&](const Scene& of) {
    const Scene made = testing::run("tessellate(parts=8)", of).scene;
    const auto all = decode_vec3(*made.draws[0].full().vertices->find("NORMAL"));
    const auto at = positions_in(made);
    std::vector<glm::vec3> inside;
    for (std::size_t v = 0; v < all.size(); ++v) {
      if (at[v].x > 0.3f && at[v].x < 1.7f) inside.push_back(all[v]);
    }
    return inside;
  };
  const glm::vec3 slope = glm::normalize(glm::vec3(-64.0f / 63, 0, 1));
  for (const glm::vec3& normal : normals(scene)) EXPECT_LT(glm::length(normal - slope), 0.01f);
  scene.materials[0].normal_map = Texture{};
  for (const glm::vec3& normal : normals(scene)) EXPECT_EQ(normal, glm::vec3(0, 0, 1)) << "the normal map refers to it";
}

TEST(Tessellate, KeepsCreases) {
  // Two squares that meet at a right angle, each with normals of its own.
  testing::TestMesh mesh = testing::joined(testing::grid(1, 1), testing::grid(1, 1));
  for (std::size_t v = 4; v < 8; ++v) mesh.positions[v] = {1, mesh.positions[v].y, -mesh.positions[v].x};
  const std::vector<glm::vec2> uv(8, glm::vec2(0.5f));
  Scene scene = testing::displaced_scene(
      mesh, uv, testing::height_image(1, 1, [](auto, auto) { return std::uint16_t{65535}; }), 0.5f);
  std::vector<glm::vec3> stored(8, {0, 0, 1});
  std::fill(stored.begin() + 4, stored.end(), glm::vec3(1, 0, 0));
  VertexStreams vertices = *scene.draws[0].full().vertices;
  vertices.base.push_back(testing::float_stream("NORMAL", stored));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(vertices);
  const Scene made = testing::run("tessellate(parts=4)", scene).scene;
  const auto at = positions_in(made);
  const auto normals = decode_vec3(*made.draws[0].full().vertices->find("NORMAL"));
  // Along the edge both sides lie in the same places, and their normals still differ.
  std::map<std::tuple<float, float, float>, std::vector<glm::vec3>> places;
  for (std::size_t v = 0; v < at.size(); ++v) places[{at[v].x, at[v].y, at[v].z}].push_back(normals[v]);
  int shared = 0;
  for (const auto& [place, both] : places) {
    if (both.size() != 2) continue;
    EXPECT_LT(glm::dot(both[0], both[1]), 0.9f);
    ++shared;
  }
  EXPECT_EQ(shared, 5);
}

/// It is there to be used up: nobody is to be told to tessellate first.
TEST(Tessellate, DoesNotUndoWhatDisplacementMade) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto pipeline = parse_line("displacement(factor=2), tessellate", diagnostics);
  EXPECT_TRUE(plan(*pipeline, registry, testing::displaced_grid(2, 2, hill(8)), diagnostics));
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
}

TEST(Tessellate, RefusesMoreTrianglesThanItMayMake) {
  const Scene scene = testing::displaced_grid(4, 4, hill(64), 2);
  const Result result = testing::run("tessellate(parts=64, most=1000)", scene);
  EXPECT_EQ(result.scene.draws[0].full().stream().triangle_count(), 32u);
  EXPECT_TRUE(result.scene.materials[0].displacement);
}

TEST(Tessellate, LeavesAnotherDrawsDisplacementOfTheSameMaterial) {
  Scene scene = testing::displaced_grid(2, 2, hill(16), 2);
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].full().orders.push_back(scene.draws[1].full().stream());  // several orders: it stays
  scene.meshes[0].draws.push_back(1);
  const Scene made = testing::run("tessellate(parts=2)", scene).scene;
  EXPECT_FALSE(made.material_of(made.draws[0])->displacement);
  EXPECT_TRUE(made.material_of(made.draws[1])->displacement);
}

TEST(Tessellate, IsWatertightAlongSeamsInEverySpacing) {
  testing::TestMesh sphere = testing::sphere(12, 8);
  for (glm::vec3& p : sphere.positions) p = glm::round(p * 1024.0f) / 1024.0f;  // it closes to the bit
  std::vector<glm::vec2> uv;
  for (const glm::vec3& p : sphere.positions) uv.emplace_back(0.5f + 0.4f * p.x, 0.5f + 0.4f * p.y);
  for (const char* spacing : {"equal", "fractional-odd", "fractional-even"}) {
    const Scene scene = testing::displaced_scene(sphere, uv, hill(256), 0.2f);
    const Scene made = testing::run("tessellate(texels=4, spacing='" + std::string(spacing) + "')", scene).scene;
    const auto at = positions_in(made);
    const auto indices = made.draws[0].full().stream().indices.view();
    using Place = std::tuple<float, float, float>;
    std::map<std::pair<Place, Place>, int> edges;
    const auto place = [&](std::uint32_t v) { return Place{at[v].x, at[v].y, at[v].z}; };
    for (std::size_t t = 0; t < indices.size(); t += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Place a = place(indices[t + c]), b = place(indices[t + (c + 1) % 3]);
        if (a < b) ++edges[{a, b}];
        if (b < a) --edges[{b, a}];
      }
    }
    int open = 0;
    for (const auto& [edge, count] : edges) open += count != 0;
    EXPECT_EQ(open, 0) << spacing;
    EXPECT_GT(edges.size(), 1000u);
  }
}

}  // namespace
}  // namespace foredraw
