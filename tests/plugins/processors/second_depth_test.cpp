// Which shells are closed, whatever touches them.
#include "plugins/processors/second_depth/shells.h"

#include "hidden_shapes.h"
#include "support/closed_bodies.h"
#include "support/meshes.h"

#include <foredraw/analysis/welded_positions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foredraw::second_depth_test {
namespace {

using processors::second_depth::Kind;
using testing::box;
using testing::joined;
using testing::TestMesh;

std::vector<Kind> kinds_of(const TestMesh& mesh) {
  return processors::second_depth::kinds_of(mesh.positions, welded(mesh.positions), mesh.indices);
}

/// So many triangles of one kind behind the other.
std::vector<Kind> kinds(std::initializer_list<std::pair<std::size_t, Kind>> runs) {
  std::vector<Kind> all;
  for (const auto& [count, kind] : runs) all.insert(all.end(), count, kind);
  return all;
}

/// Two triangles, each corner a vertex of its own.
TestMesh quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  return {{a, b, c, a, c, d}, {0, 1, 2, 3, 4, 5}};
}

TestMesh without_first(TestMesh mesh, std::size_t triangles) {
  mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangles));
  return mesh;
}

TEST(Shells, WholeOnesAreClosedAndOthersOpen) {
  EXPECT_EQ(kinds_of(box()), kinds({{12, Kind::closed}}));
  EXPECT_EQ(kinds_of(testing::closed_torus(24, 12, 1, 0.4f)), kinds({{576, Kind::closed}}));
  EXPECT_EQ(kinds_of(testing::closed_sphere(24, 12)), kinds({{528, Kind::closed}}));
  EXPECT_EQ(kinds_of(testing::torus(24, 12)), kinds({{576, Kind::open}})) << "its seam does not meet in the last bits";
  EXPECT_EQ(kinds_of(without_first(box(), 1)), kinds({{11, Kind::open}}));
  EXPECT_EQ(kinds_of(testing::grid(3, 3)), kinds({{18, Kind::open}}));
  EXPECT_TRUE(kinds_of({}).empty());
  EXPECT_EQ(kinds_of(joined(box(), box(1, {5, 0, 0}, true))), kinds({{12, Kind::closed}, {10, Kind::open}}));
}

TEST(Shells, InsideOutOnesAndCavities) {
  EXPECT_EQ(kinds_of(testing::turned(box())), kinds({{12, Kind::inside_out}}));
  // The walls of a double-walled box: the outer one hides the inner one.
  EXPECT_EQ(kinds_of(joined(box(), testing::turned(box(0.5f)))), kinds({{12, Kind::closed}, {12, Kind::inside_out}}));
}

TEST(Shells, TouchingInAVertexOrAnEdgeAreToldApart) {
  const TestMesh at_vertex = joined(box(), box(1, {2, 2, 2}));
  EXPECT_EQ(kinds_of(at_vertex), kinds({{24, Kind::closed}}));
  const TestMesh at_edge = joined(box(), box(1, {2, 2, 0}));
  EXPECT_EQ(kinds_of(at_edge), kinds({{24, Kind::closed}}));
  // One of them open: the other one stays closed.
  EXPECT_EQ(kinds_of(joined(box(), box(1, {2, 2, 2}, true))), kinds({{12, Kind::closed}, {10, Kind::open}}));
  EXPECT_EQ(kinds_of(joined(box(), box(1, {2, 2, 0}, true))), kinds({{12, Kind::closed}, {10, Kind::open}}));
  // A sheet that stands on an edge of a box.
  const TestMesh fin = quad({1, 1, -1}, {1, 1, 1}, {1, 3, 1}, {1, 3, -1});
  EXPECT_EQ(kinds_of(joined(box(), fin)), kinds({{12, Kind::closed}, {2, Kind::open}}));
}

TEST(Shells, WallsThatCoincide) {
  // Boxes side by side: the wall between them is there twice, and nobody sees it.
  EXPECT_EQ(kinds_of(joined(box(), box(1, {2, 0, 0}))), kinds({{24, Kind::closed}}));
  // A two-sided sheet of one thickness: its back would hide its front.
  const TestMesh sheet = quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  const TestMesh other_diagonal = quad({0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0});
  EXPECT_EQ(kinds_of(joined(sheet, other_diagonal)), kinds({{4, Kind::flat}}));
  // The same as a fin on the edge of a box.
  const TestMesh fin = quad({1, 1, -1}, {1, 1, 1}, {1, 3, 1}, {1, 3, -1});
  EXPECT_EQ(kinds_of(joined(box(), joined(fin, testing::turned(fin)))), kinds({{12, Kind::closed}, {4, Kind::flat}}));
  // The same box twice is one shell, in one place.
  EXPECT_EQ(kinds_of(joined(box(), box())), kinds({{24, Kind::closed}}));
  // Once right side out and once inside out: nothing is left of it.
  EXPECT_EQ(kinds_of(joined(box(), testing::turned(box()))), kinds({{24, Kind::flat}}));
}

/// A prism whose far end is mirrored and smaller, so that two walls pass through each other: the small part shows its
/// backs, though the volume of the whole is above 0.
TEST(Shells, ThatPassThroughThemselvesAreNotRightSideOut) {
  TestMesh twisted = box();
  for (std::size_t i = 4; i < 8; ++i) twisted.positions[i].x *= -0.5f;
  EXPECT_EQ(kinds_of(twisted), kinds({{12, Kind::turned}}));
  // Passing through itself alone is no harm: a chain link that touches itself from outside.
  TestMesh overlapping = joined(box(), box(1, {0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(kinds_of(overlapping), kinds({{24, Kind::closed}}));
}

TEST(Shells, ATriangleThatIsThereTwiceOrTurnedOpensThem) {
  TestMesh doubled = box();
  doubled.indices.insert(doubled.indices.end(), {0, 2, 1});
  EXPECT_EQ(std::ranges::count(kinds_of(doubled), Kind::closed), 0);
  TestMesh turned = box();
  std::swap(turned.indices[1], turned.indices[2]);
  EXPECT_EQ(std::ranges::count(kinds_of(turned), Kind::closed), 0);
}

TEST(Shells, AMoebiusRibbonIsOpen) {
  constexpr std::uint32_t steps = 24;
  TestMesh ribbon;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / steps;
    const glm::vec3 out(std::cos(a), 0, std::sin(a));
    const glm::vec3 across = std::cos(a / 2) * out + glm::vec3(0, std::sin(a / 2), 0);
    ribbon.positions.push_back(out + 0.2f * across);
    ribbon.positions.push_back(out - 0.2f * across);
  }
  for (std::uint32_t i = 0; i < steps; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1;
    const bool is_last = i + 1 == steps;  // its sides change places there
    const std::uint32_t c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
    ribbon.indices.insert(ribbon.indices.end(), {a, b, c, b, d, c});
  }
  EXPECT_EQ(kinds_of(ribbon), kinds({{2 * steps, Kind::open}}));
}

TEST(Shells, WithPlacesThatAreNotFiniteAreOpenAndThoseOfAnySizeAreClosed) {
  TestMesh odd = joined(box(), box(1, {9, 0, 0}));
  odd.positions[0].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(kinds_of(odd), kinds({{12, Kind::open}, {12, Kind::closed}}));
  odd.positions[0].x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(kinds_of(odd), kinds({{12, Kind::open}, {12, Kind::closed}}));
  for (const float size : {1e-30f, 1e-6f, 1e6f, 1e30f}) {
    EXPECT_EQ(kinds_of(box(size)), kinds({{12, Kind::closed}})) << size;
  }
  EXPECT_EQ(kinds_of(box(0)), kinds({{12, Kind::flat}})) << "all corners in one place";
}

TEST(Shells, AreTheSameAtAnyNumberOfThreads) {
  TestMesh many;
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 at(3.f * static_cast<float>(i % 7), 3.f * static_cast<float>(i / 7), 0);
    many = joined(many, i % 3 == 0 ? testing::turned(box(1, at)) : box(1, at, i % 5 == 0));
  }
  many = testing::shuffled(many, 4);
  const auto points = welded(many.positions);
  const Executor one(1), four(4);
  const auto alone = processors::second_depth::kinds_of(many.positions, points, many.indices, {.executor = &one});
  EXPECT_EQ(processors::second_depth::kinds_of(many.positions, points, many.indices, {.executor = &four}), alone);
  EXPECT_GT(std::ranges::count(alone, Kind::closed), 200);
}

}  // namespace
}  // namespace foredraw::second_depth_test
