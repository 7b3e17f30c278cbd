// Shapes that look alike and are not: what is seen of each, and that it looks the same before and after.

#include "plugins/processors/sides/applied_sides.h"
#include "plugins/processors/sides/side_gains.h"
#include "plugins/processors/sides/side_search.h"
#include "plugins/processors/sides/surface.h"
#include "support/meshes.h"
#include "support/same_look.h"

#include <foredraw/analysis/closed_surfaces.h>
#include <foredraw/image/found_traits.h>
#include <foredraw/viewing/view_directions.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw::sides_shapes_test {
namespace {

using processors::sides::Side;
using testing::TestMesh;

TestMesh body(glm::vec3 half = {1, 1, 1}, glm::vec3 centre = {0, 0, 0}) {
  TestMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(centre + half * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  mesh.indices = {0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 0, 4, 2, 2, 4, 6,
                  1, 3, 5, 3, 7, 5, 2, 6, 3, 3, 6, 7, 4, 5, 6, 5, 7, 6};
  return mesh;
}

TestMesh inside_out(TestMesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

/// Rings of `sides` points about a path; joined from each ring to the next.
TestMesh tube_along(const std::vector<glm::vec3>& path, float radius, bool is_closed) {
  constexpr std::uint32_t around = 8;
  TestMesh mesh;
  const auto count = static_cast<std::uint32_t>(path.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 along =
        glm::normalize(path[is_closed || i + 1 < count ? (i + 1) % count : i] - path[is_closed ? (i + count - 1) % count
                                                                                     : i == 0  ? 0
                                                                                               : i - 1]);
    const glm::vec3 right = glm::normalize(glm::cross(along, glm::vec3(0, 0, 1)));
    const glm::vec3 up = glm::cross(right, along);
    for (std::uint32_t a = 0; a < around; ++a) {
      const float angle = 6.2831853f * static_cast<float>(a) / around;
      mesh.positions.push_back(path[i] + radius * (std::cos(angle) * right + std::sin(angle) * up));
    }
  }
  for (std::uint32_t i = 0; i + (is_closed ? 0 : 1) < count; ++i) {
    for (std::uint32_t a = 0; a < around; ++a) {
      const std::uint32_t p = i * around + a, q = i * around + (a + 1) % around;
      const std::uint32_t r = (i + 1) % count * around + a, s = (i + 1) % count * around + (a + 1) % around;
      mesh.indices.insert(mesh.indices.end(), {p, r, q, q, r, s});
    }
  }
  return mesh;
}

TestMesh open_tube() { return tube_along({{-2, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0.5f, false); }

TestMesh figure_eight() {
  std::vector<glm::vec3> path;
  for (int i = 0; i < 48; ++i) {
    const float t = 6.2831853f * static_cast<float>(i) / 48;
    path.emplace_back(2 * std::sin(t), std::sin(2 * t), 0);  // passes through itself in the middle
  }
  return tube_along(path, 0.3f, true);
}

TestMesh moebius_strip() {
  TestMesh mesh;
  constexpr std::uint32_t count = 32;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float t = 6.2831853f * static_cast<float>(i) / count;
    const glm::vec3 out(std::cos(t), std::sin(t), 0);
    const glm::vec3 across = std::cos(t / 2) * out + std::sin(t / 2) * glm::vec3(0, 0, 1);
    mesh.positions.push_back(2.f * out + 0.6f * across);
    mesh.positions.push_back(2.f * out - 0.6f * across);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool is_last = i + 1 == count;  // and there the strip is turned over
    const std::uint32_t a = 2 * i, b = a + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
    mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
  }
  return mesh;
}

Draw double_sided_draw(const TestMesh& mesh) {
  Draw draw = testing::draw_of(mesh);
  VertexStreams streams = *draw.full().vertices;
  std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0));
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]];
    const glm::vec3 n = glm::cross(b - a, mesh.positions[mesh.indices[i + 2]] - a);
    for (std::size_t c = 0; c < 3; ++c) normals[mesh.indices[i + c]] += n;
  }
  std::vector<std::byte> bytes(normals.size() * sizeof(glm::vec3));
  std::memcpy(bytes.data(), normals.data(), bytes.size());
  streams.base.push_back({"NORMAL", {Component::float32, 3, false, 12}, Shared(std::move(bytes))});
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(streams));
  draw.material = 0;
  return draw;
}

Scene double_sided_scene(const TestMesh& mesh) {
  Scene scene = testing::scene_of({double_sided_draw(mesh)});
  scene.materials.resize(1);
  scene.materials[0].double_sided = true;
  find_traits(scene);
  return scene;
}

std::vector<Side> found(const Scene& scene) {
  testing::RunFixture fixture;
  processors::sides::SideSearchOptions options{.rays = 64, .checks = 40, .views = {{}, 96}};
  for (const glm::dvec3& direction : fibonacci_directions(40)) options.views.views.push_back({direction});
  const DrawId asked[] = {0};
  return processors::sides::find_sides(scene, asked, options, fixture.analyses, fixture.executor).wanted.at(0);
}

struct Seen {
  std::size_t fronts = 0, both = 0, backs = 0;
  friend bool operator==(const Seen&, const Seen&) = default;
};

/// What is seen of it; and it looks the same, drawn single-sided with copies.
Seen seen(const TestMesh& mesh) {
  const Scene before = double_sided_scene(mesh);
  const std::vector<Side> wanted = found(before);
  Scene after = before;
  processors::sides::SingleSidedMaterials materials(after);
  processors::sides::make_single_sided(after, 0, wanted, materials);
  EXPECT_FALSE(after.material_of(after.draws[0])->double_sided);
  const testing::Looks looks = testing::compared(before, after, {.pictures = 60, .size = 200}, Executor(2));
  EXPECT_GT(looks.shown, 100000u);
  EXPECT_EQ(looks.lost, 0u);
  EXPECT_EQ(looks.moved, 0u);
  EXPECT_EQ(looks.coloured, 0u);
  Seen result;
  for (const Side sides : wanted)
    ++(sides == processors::sides::front  ? result.fronts
       : sides == processors::sides::both ? result.both
                                          : result.backs);
  return result;
}

TEST(SidesShapes, BoxesAreSeenFromOneSide) {
  EXPECT_EQ(seen(body()), (Seen{12, 0, 0}));
  EXPECT_EQ(seen(inside_out(body())), (Seen{0, 0, 12}));
}

TEST(SidesShapes, ATubeIsSeenThrough) { EXPECT_EQ(seen(open_tube()), (Seen{0, 64, 0})); }

TEST(SidesShapes, AMoebiusStripHasTwoSidesEverywhere) { EXPECT_EQ(seen(moebius_strip()), (Seen{0, 64, 0})); }

/// Its back shows outwards. Its neighbours are kept from both sides, as what touches a back that is seen is.
TEST(SidesShapes, OneTurnedTriangleOfABoxShowsItsBack) {
  TestMesh mesh = body();
  std::swap(mesh.indices[1], mesh.indices[2]);
  const Seen one = seen(mesh);
  EXPECT_GE(one.both + one.backs, 1u);
  EXPECT_GE(one.fronts, 2u);
}

TEST(SidesShapes, BodiesThatPassThroughEachOtherHaveFrontsAlone) {
  EXPECT_EQ(seen(testing::joined(body(), body({0.5f, 0.5f, 2}, {0.3f, 0.2f, 0.1f}))), (Seen{24, 0, 0}));
  EXPECT_EQ(seen(figure_eight()), (Seen{48 * 8 * 2, 0, 0}));
}

/// Walls without area, the same face twice, and a vertex that is nowhere.
TEST(SidesShapes, OddTrianglesDoNoHarm) {
  TestMesh flat = body();
  flat.indices.insert(flat.indices.end(), {0, 0, 1, 2, 2, 2, 0, 1, 0});
  EXPECT_EQ(seen(flat).fronts, 15u);
  TestMesh twice = body();
  twice.indices.insert(twice.indices.end(), {0, 2, 1, 1, 2, 3});
  EXPECT_EQ(seen(twice).backs, 0u);
  TestMesh nowhere = testing::sphere(16, 9);
  nowhere.positions[40].y = std::numeric_limits<float>::quiet_NaN();
  const Seen holed = seen(nowhere);  // one sees into it
  EXPECT_GT(holed.both, holed.fronts);
}

processors::sides::SideGains gains(const TestMesh& mesh, int threads, std::vector<Side> wanted = {}) {
  wanted.resize(mesh.indices.size() / 3, processors::sides::front);
  Views views{{}, 64};
  for (const glm::dvec3& direction : fibonacci_directions(30)) views.views.push_back({direction});
  Analyses analyses;
  return processors::sides::side_gains(double_sided_scene(mesh), {{0, wanted}}, views, rest_pose,
                                       SubjectUnit::character, analyses, Executor(threads));
}

/// A sheet hides nothing of itself. Of a body, each wall is in front from one side and behind from the other.
TEST(SidesGains, AreOfTrianglesThatHideAndAreHidden) {
  const processors::sides::SideGains sheet = gains(testing::grid(4, 4), 1);
  EXPECT_GT(sheet.visible, 0);
  EXPECT_EQ(sheet.of.at(0), std::vector<double>(32, 0));
  const processors::sides::SideGains box = gains(body(), 1);
  for (const double gain : box.of.at(0)) {
    EXPECT_GT(gain, 0.02 * box.visible);
    EXPECT_LT(gain, 0.06 * box.visible) << "half of a twelfth, as backs are as often behind as fronts are in front";
  }
  EXPECT_EQ(gains(open_tube(), 1).of, gains(open_tube(), 2).of);
}

/// What will not be drawn any more is not hidden, and hides nothing.
TEST(SidesGains, OfCopiesAreAmongWhatIsWanted) {
  const double all_sides = gains(body(), 1).of.at(0).front();
  const std::vector<Side> every(12, processors::sides::both);
  EXPECT_EQ(gains(body(), 1, every).of.at(0).front(), all_sides);
  EXPECT_EQ(gains(body(), 1, {processors::sides::both}).of.at(0).front(), 0) << "no other back is behind its front";
  const std::vector<double> beside = gains(body(), 1, {processors::sides::both}).of.at(0);
  EXPECT_EQ(beside.back(), gains(body(), 1).of.at(0).back()) << "a back that goes saves what it cost";
}

TEST(SidesSurface, SmoothsValuesOverNeighbours) {
  const TestMesh strip{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}}, {0, 1, 2, 2, 1, 3, 2, 3, 4}};
  const processors::sides::Surface surface = processors::sides::surface_of(strip.positions, strip.indices);
  std::vector<double> values{6, 0, 3};
  processors::sides::smooth(surface, values);
  EXPECT_EQ(values, (std::vector<double>{3, 3, 1.5}));
}

TEST(SidesSurface, TellsWhereASurfaceEnds) {
  const TestMesh mesh = testing::joined(open_tube(), body({1, 1, 1}, {9, 0, 0}));
  const processors::sides::Surface surface = processors::sides::surface_of(mesh.positions, mesh.indices);
  EXPECT_EQ(surface.rims.size(), 16u);
  EXPECT_EQ(surface.rims_of(surface.component.front()).size(), 16u);
  EXPECT_EQ(surface.rims_of(surface.component.back()).size(), 0u);
  EXPECT_EQ(surface.opening(0).size(), 8u);
  EXPECT_EQ(surface.opening(1).size(), 8u);
  std::vector<Side> sides(64 + 12, processors::sides::front);
  processors::sides::add_rims(surface, sides);
  EXPECT_EQ(std::ranges::count(sides, processors::sides::both), 16);
  std::ranges::fill(sides, processors::sides::front);
  sides[20] = processors::sides::both;
  processors::sides::add_neighbours(surface, sides);
  EXPECT_EQ(std::ranges::count(sides, processors::sides::both), 4);
}

}  // namespace
}  // namespace foredraw::sides_shapes_test
