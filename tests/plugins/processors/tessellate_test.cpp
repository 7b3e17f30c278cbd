#include "plugins/processors/tessellate/tessellate.h"

#include "support/displaced.h"
#include "support/staged.h"
#include "support/uv_charts.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace foredraw::tessellate_test {
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

/// A cube's face laid out as a chart, and a height for each point of the cube, which none of our own code computes.
struct TrueHeights {
  std::array<testing::ChartPlace, 6> places = testing::turned_places();

  /// All texels that a chart reads are its own.
  TrueHeights() { places[2] = {{.84f, .16f}, {.14f, 0}, {0, .14f}}; }

  /// The two coordinates on a face, from -1 to 1 where the chart is.
  glm::dvec2 on_face(std::size_t face, const glm::dvec2& uv) const {
    const glm::dvec2 a(places[face].along_u), b(places[face].along_v), off = uv - glm::dvec2(places[face].middle);
    return glm::dvec2(off.x * b.y - off.y * b.x, a.x * off.y - a.y * off.x) / (a.x * b.y - a.y * b.x);
  }

  double at(const glm::dvec2& uv) const {
    std::size_t face = 0;
    const auto beside = [&](std::size_t f) {
      const glm::dvec2 place = glm::abs(on_face(f, uv));
      return std::max(place.x, place.y);
    };
    for (std::size_t f = 1; f < 6; ++f) face = beside(f) < beside(face) ? f : face;
    const glm::dvec2 place = on_face(face, uv);
    glm::dvec3 p;
    const std::size_t axis = face / 2;
    p[static_cast<int>(axis)] = face % 2 == 0 ? 1 : -1;
    p[static_cast<int>((axis + 1) % 3)] = place.x;
    p[static_cast<int>((axis + 2) % 3)] = place.y;
    return 0.5 + 0.15 * std::sin(3 * p.x + p.y) + 0.15 * std::sin(2 * p.y - 3 * p.z) + 0.15 * std::sin(4 * p.z + 1);
  }
};

struct HeightErrors {
  std::size_t points = 0;
  double largest = 0, rms = 0;
};

/// Of heights that the stages show, as parts of the map's range.
HeightErrors height_errors(const std::string& stages) {
  const TrueHeights truth;
  const testing::Charts charts = testing::cube_sphere(6, truth.places);
  constexpr std::uint32_t size = 1024;
  const Image map = testing::height_image(size, size, [&](std::uint32_t x, std::uint32_t y) {
    return static_cast<std::uint16_t>(std::lround(65535 * truth.at({(x + 0.5) / size, (y + 0.5) / size})));
  });
  const auto made = [&](float factor, float offset) {
    return testing::run(stages,
                        testing::displaced_scene({charts.positions, charts.indices}, charts.uvs, map, factor, offset))
        .scene;
  };
  const Scene moved = made(0.25f, 0);
  const auto shown = positions_in(moved), flat = positions_in(made(0, 0)), unit = positions_in(made(0, 1));
  const VertexStream& uvs = *moved.draws[0].full().vertices->find("TEXCOORD_0");
  HeightErrors errors{shown.size()};
  for (std::size_t v = 0; v < shown.size(); ++v) {
    const double moves = glm::length(glm::dvec3(shown[v] - flat[v])),
                 whole = glm::length(glm::dvec3(unit[v] - flat[v]));
    const double off = moves / whole / 0.25 - truth.at({decode_component(uvs, v, 0), decode_component(uvs, v, 1)});
    errors.largest = std::max(errors.largest, std::abs(off));
    errors.rms += off * off / static_cast<double>(shown.size());
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

/// In charts turned, mirrored and stretched by four. What makes both sides of a seam equal moves them by little more
/// than they are off.
TEST(Tessellate, ShowsTheTrueHeightsOfASphereInTurnedCharts) {
  const HeightErrors raw = height_errors("tessellate(parts=8)");
  EXPECT_GT(raw.points, 10'000u);
  EXPECT_GT(raw.largest, 0) << "texels are not the truth";
  EXPECT_LT(raw.largest, 0.00025);
  EXPECT_LT(raw.rms, 0.00005);
  const HeightErrors repaired = height_errors("displacement-seams, tessellate(parts=8)");
  EXPECT_LT(repaired.largest, 0.0006);
  EXPECT_LT(repaired.rms, 0.00005);
}

}  // namespace
}  // namespace foredraw::tessellate_test
