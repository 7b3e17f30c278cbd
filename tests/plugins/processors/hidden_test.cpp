#include "plugins/processors/hidden/hidden.h"

#include "hidden_shapes.h"
#include "plugins/processors/hidden/connected.h"
#include "plugins/processors/hidden/contained.h"
#include "plugins/processors/hidden/cut_draw.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <limits>

namespace foredraw::hidden_test {
namespace {

using processors::hidden::Unit;
using testing::box;
using testing::TestMesh;

HiddenOptions few(Unit unit = Unit::component) {
  HiddenOptions options;
  options.unit = unit;
  options.views = 80;
  options.size = 128;
  options.rays = 256;
  options.checks = 60;
  return options;
}

/// How many triangles of the mesh are hidden, and by what.
std::size_t hidden_of(const TestMesh& mesh, const HiddenOptions& options = few(), bool is_double_sided = false,
                      bool is_opaque = true) {
  const OpaqueOrNot draw[] = {{mesh.positions, mesh.indices, is_double_sided, is_opaque}};
  const HiddenTriangles found = hidden_triangles(draw, options, Executor(2));
  return static_cast<std::size_t>(std::ranges::count(found.is_hidden[0], 1));
}

/// A sphere cut in half: it opens to +Y.
TestMesh bowl() {
  TestMesh mesh = testing::sphere(32, 17);
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    if (mesh.positions[mesh.indices[i]].y > 0.01f) continue;
    kept.insert(kept.end(), &mesh.indices[i], &mesh.indices[i] + 3);
  }
  mesh.indices = kept;
  return mesh;
}

TEST(Hidden, OfWhatIsOpenNothingIs) {
  for (const bool is_double_sided : {false, true}) {
    EXPECT_EQ(hidden_of(testing::torus(24, 12), few(Unit::triangle), is_double_sided), 0u);
    EXPECT_EQ(hidden_of(bowl(), few(Unit::triangle), is_double_sided), 0u);
    EXPECT_EQ(hidden_of(box(), few(Unit::triangle), is_double_sided), 0u);
  }
  EXPECT_EQ(hidden_of(testing::joined(bowl(), box(0.1f, {0, -0.7f, 0})), few(Unit::triangle), true), 0u);
}

TEST(Hidden, ABoxInABoxIs) {
  EXPECT_EQ(hidden_of(testing::joined(box(), box(0.5f))), 12u);
  EXPECT_EQ(hidden_of(testing::joined(box(), box(0.5f)), few(Unit::triangle)), 12u);
  EXPECT_EQ(hidden_of(testing::joined(box(), testing::joined(box(0.5f), box(0.2f)))), 24u);
}

TEST(Hidden, WhatSticksOutStays) {
  EXPECT_EQ(hidden_of(testing::joined(box(), box(0.3f, {0.9f, 0, 0}))), 0u);
  EXPECT_EQ(hidden_of(testing::joined(box(), box(0.3f, {0, 0, 0.7001f}))), 0u);  // by a ten thousandth
}

/// What lies in the wall of something else, and just as near.
TEST(Hidden, WhatIsEquallyNearStays) {
  EXPECT_EQ(hidden_of(testing::joined(box(), box())), 0u);
  TestMesh sheet = box();
  sheet.indices = {3, 7, 5};
  EXPECT_EQ(hidden_of(testing::joined(box(), sheet)), 0u);
}

TEST(Hidden, SingleSidedWallsHideFromTheirFrontAlone) {
  EXPECT_EQ(hidden_of(testing::joined(testing::turned(box()), box(0.5f))), 0u);
  EXPECT_EQ(hidden_of(testing::joined(testing::turned(box()), box(0.5f)), few(), true), 12u);
  EXPECT_EQ(hidden_of(testing::joined(box(), testing::turned(box(0.99f)))), 12u);  // the wall's inside
}

TEST(Hidden, WhatIsNotOpaqueHidesNothing) {
  EXPECT_EQ(hidden_of(testing::joined(box(), box(0.5f)), few(), false, false), 0u);
}

/// A box behind a hole of a thousandth of the radius: one view in some hundred sees something through it.
TEST(Hidden, AKeyholeIsEnough) {
  const TestMesh room = testing::ball_with_hole(0.001f);
  HiddenOptions options;
  options.rays = 0;
  EXPECT_EQ(hidden_of(testing::joined(room, box(0.5f)), options, true), 0u);
  EXPECT_EQ(hidden_of(testing::joined(testing::sphere(64, 33), box(0.5f)), options, true), 12u);
}

/// A slot that no picture of 16 pixels shows; the rays alone see through it.
TEST(Hidden, RaysFindWhatPicturesMiss) {
  const TestMesh room = testing::joined(testing::ball_with_hole(0.02f), testing::sphere(24, 13, 0.5f));
  HiddenOptions options = few();
  options.views = 12;
  options.size = 16;
  options.checks = 1;
  options.rays = 0;
  EXPECT_GT(hidden_of(room, options, true), 0u);
  options.rays = 4096;
  EXPECT_EQ(hidden_of(room, options, true), 0u);
}

/// Two rings around what is seen: of two boxes through each other the corners inside go, but for those next to it.
TEST(Hidden, TrianglesGoOneByOneBehindTwoRings) {
  TestMesh deep = testing::grid(40, 4);  // through the wall of a box, most of it inside
  for (glm::vec3& p : deep.positions) p = {p.x * 0.05f - 0.5f, (p.y - 2) * 0.02f, 0};
  const TestMesh both = testing::joined(box(), deep);
  EXPECT_EQ(hidden_of(both, few(), true), 0u);
  const std::size_t gone = hidden_of(both, few(Unit::triangle), true);
  // 30 columns of 8 end at the wall; the one in it and two more before it stay.
  EXPECT_GE(gone, 26u * 8);
  EXPECT_LE(gone, 28u * 8);
}

TEST(Hidden, OddTrianglesStayOrCoverNothing) {
  EXPECT_EQ(hidden_of({}), 0u);
  EXPECT_EQ(hidden_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}}), 0u);
  TestMesh broken = testing::joined(box(), box(0.5f));
  broken.positions[9].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(hidden_of(broken), 0u);  // its component stays
  broken.positions[9].x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(hidden_of(broken), 0u);
  TestMesh flat = box();
  flat.indices.insert(flat.indices.end(), {0, 0, 1, 2, 2, 2});
  EXPECT_EQ(hidden_of(flat), 0u);
  TestMesh wall = testing::joined(box(), {{{0, 0, 0}, {0.5f, 0, 0}, {0.25f, 0, 0}}, {0, 1, 2}});
  EXPECT_EQ(hidden_of(wall, few(), true), 1u);  // shows nothing anywhere
}

TEST(Hidden, TheSameAtAnyThreadCount) {
  const TestMesh heap = testing::joined(testing::soup(3000, 5), box(0.3f, glm::vec3(0.5f)));
  const OpaqueOrNot draw[] = {{heap.positions, heap.indices, true}};
  const HiddenTriangles one = hidden_triangles(draw, few(Unit::triangle), Executor(1));
  const HiddenTriangles four = hidden_triangles(draw, few(Unit::triangle), Executor(4));
  EXPECT_EQ(one.is_hidden, four.is_hidden);
  EXPECT_EQ(one.last_check.shown, four.last_check.shown);
}

std::size_t proved_of(const TestMesh& mesh, bool is_opaque = true) {
  const OpaqueOrNot draw[] = {{mesh.positions, mesh.indices, false, is_opaque}};
  const HiddenTriangles found = hidden_triangles(draw, few(), Executor(2));
  return static_cast<std::size_t>(std::ranges::count(found.is_proved[0], 1));
}

/// Its seams fit bit by bit.
TestMesh closed_torus() {
  TestMesh mesh = testing::torus(24, 12);
  for (glm::vec3& p : mesh.positions) p = glm::round(p * 4096.f) / 4096.f;
  return mesh;
}

TEST(HiddenProof, WhatIsWithinSomethingClosedNeedsNoSample) {
  EXPECT_EQ(proved_of(testing::joined(box(), box(0.5f))), 12u);
  EXPECT_EQ(proved_of(testing::joined(box(), testing::turned(box(0.5f)))), 12u);
  EXPECT_EQ(proved_of(testing::joined(box(), testing::joined(box(0.5f), box(0.2f)))), 24u);
  EXPECT_EQ(proved_of(testing::joined(box(), testing::grid(1, 1))), 0u);  // touches the wall
  // Within the hole of a torus is not within it, nor is what its wall goes through.
  EXPECT_EQ(proved_of(testing::joined(closed_torus(), box(0.1f))), 0u);
  EXPECT_EQ(proved_of(testing::joined(closed_torus(), box(0.1f, {1, 0, 0}))), 12u);
  EXPECT_EQ(proved_of(testing::joined(closed_torus(), box(0.5f, {1, 0, 0}))), 0u);
}

TEST(HiddenProof, NotWhatLooksSoToSamplesAlone) {
  EXPECT_EQ(proved_of(testing::joined(box(), box(0.5f)), false), 0u);
  EXPECT_EQ(proved_of(testing::joined(testing::turned(box()), box(0.5f))), 0u);
  TestMesh hull = box();
  hull.indices.insert(hull.indices.end(), {0, 1, 2});  // not closed, and seen by nobody
  const TestMesh in_hull = testing::joined(hull, box(0.5f));
  EXPECT_EQ(hidden_of(in_hull), 12u);
  EXPECT_EQ(proved_of(in_hull), 0u);
}

/// Asked about everything, whether anybody sees it or not.
std::size_t contained_in(const TestMesh& mesh) {
  processors::hidden::Sight sight;
  sight.parts = {{mesh.positions, mesh.indices}};
  sight.hides = {1};
  for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) sight.triangles.push_back(t);
  const processors::hidden::Connected connected(sight.parts);
  const processors::hidden::Flags proved =
      processors::hidden::inside_closed(sight, connected, processors::hidden::Flags(sight.triangles.size(), 1));
  return static_cast<std::size_t>(std::ranges::count(proved, 1));
}

/// A box of which the top, +Z, is pressed in to a point in the middle.
TestMesh dented_box() {
  TestMesh dented = box();
  dented.positions.push_back({0, 0, 0});
  dented.indices.erase(dented.indices.begin() + 30, dented.indices.end());
  dented.indices.insert(dented.indices.end(), {4, 5, 8, 5, 7, 8, 7, 6, 8, 6, 4, 8});
  return dented;
}

TEST(HiddenProof, AsksEdgesOfBoth) {
  EXPECT_EQ(contained_in(testing::joined(box(), box(0.5f))), 12u);
  EXPECT_EQ(contained_in(testing::joined(dented_box(), box(0.1f, {0, 0, -0.5f}))), 12u);
  // Its vertices are within, an edge of it runs through the dent.
  const TestMesh rod{{{-0.8f, 0, 0.5f}, {0.8f, 0, 0.5f}, {0.8f, 0.1f, 0.5f}}, {0, 1, 2, 0, 2, 1}};
  EXPECT_EQ(contained_in(testing::joined(dented_box(), rod)), 0u);
  // The tip of the dent pricks through the middle of it, and no edge of it touches the dent.
  const TestMesh plate{{{-0.9f, -0.6f, 0.05f}, {0.9f, -0.6f, 0.05f}, {0, 0.9f, 0.05f}}, {0, 1, 2, 0, 2, 1}};
  EXPECT_EQ(contained_in(testing::joined(dented_box(), plate)), 0u);
  TestMesh below = plate;
  for (glm::vec3& p : below.positions) p.z = -0.05f;
  EXPECT_EQ(contained_in(testing::joined(dented_box(), below)), 2u);
}

TEST(HiddenConnected, ComponentsAndRings) {
  const TestMesh mesh = testing::joined(testing::grid(9, 1), testing::grid(2, 2));
  TestMesh apart = mesh;
  for (std::size_t v = 20; v < apart.positions.size(); ++v) apart.positions[v].z = 1;
  const RasterPart parts[] = {{apart.positions, apart.indices}};
  const processors::hidden::Connected surface(parts);
  EXPECT_EQ(surface.components(), 2u);
  processors::hidden::Flags flags(26, 0);
  flags[0] = 1;
  const processors::hidden::Flags whole = surface.with_components(flags);
  EXPECT_EQ(std::ranges::count(whole, 1), 18);
  // Triangles zigzag along the strip.
  EXPECT_EQ(std::ranges::count(surface.with_rings(flags, 0), 1), 1);
  EXPECT_EQ(std::ranges::count(surface.with_rings(flags, 1), 1), 3);
  EXPECT_EQ(std::ranges::count(surface.with_rings(flags, 2), 1), 5);
  // The same position in another part is the same place.
  const TestMesh left = testing::grid(1, 1);
  TestMesh right = testing::grid(1, 1);
  for (glm::vec3& p : right.positions) p.x += 1;
  const RasterPart two[] = {{left.positions, left.indices}, {right.positions, right.indices}};
  EXPECT_EQ(processors::hidden::Connected(two).components(), 1u);
}

TEST(HiddenCut, KeepsPlacesAndNumbers) {
  Draw draw = testing::draw_of(testing::grid(2, 1));
  const auto before = draw.full().vertices;
  processors::hidden::cut(draw, {0, 1, 1, 0});
  EXPECT_EQ(draw.full().stream().triangle_origin, Shared(std::vector<std::uint32_t>{0, 3}));
  EXPECT_EQ(draw.full().stream().indices, Shared(std::vector<std::uint32_t>{0, 1, 3, 4, 2, 5}));
  EXPECT_EQ(draw.full().vertices, before);
  processors::hidden::cut(draw, {1, 0});
  EXPECT_EQ(draw.full().stream().triangle_origin, Shared(std::vector<std::uint32_t>{3}));
  processors::hidden::cut(draw, {1});  // the last one leaves a triangle without area
  EXPECT_EQ(draw.full().stream().indices, Shared(std::vector<std::uint32_t>{4, 4, 4}));
}

}  // namespace
}  // namespace foredraw::hidden_test
