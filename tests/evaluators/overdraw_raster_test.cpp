#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "overdraw_reference.h"
#include "support/meshes.h"
#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::overdraw_raster_test {
namespace {

using testing::all_sides;
using testing::crowd;
using testing::part_of;
using testing::quad;
using testing::TestMesh;
using testing::total;
using testing::views_of;

OverdrawCount total(const TestMesh& mesh, const Views& views, bool culls_back_faces = true) {
  const RasterPart part = part_of(mesh, culls_back_faces);
  return total(overdraw_raster({&part, 1}, views));
}

// --- what is counted
// ---------------------------------------------------------------------------------------------------

TEST(OverdrawRaster, the_farther_quad_costs_only_when_drawn_first) {
  const Views front = views_of({{0, 0, 1}});
  const OverdrawCount near_first = total(testing::joined(quad(0.1f), quad(-0.1f)), front);
  EXPECT_GT(near_first.visible, 1500u);  // the square in a circle of 64 pixels
  EXPECT_EQ(near_first.shaded, near_first.visible);
  const OverdrawCount far_first = total(testing::joined(quad(-0.1f), quad(0.1f)), front);
  EXPECT_EQ(far_first.visible, near_first.visible);
  EXPECT_EQ(far_first.shaded, 2 * far_first.visible);
  EXPECT_EQ(far_first.ties, 0u);
}

TEST(OverdrawRaster, each_part_has_its_own_fragments) {
  const TestMesh far = quad(-0.1f);
  const TestMesh near = quad(0.1f);
  const std::vector<RasterPart> parts = {part_of(far), part_of(near)};
  const OverdrawCounts overdraw = overdraw_raster(parts, views_of({{0, 0, 1}, {0, 0, -1}}));
  ASSERT_EQ(overdraw[0].size(), 2u);
  EXPECT_EQ(overdraw[0][0].visible, 0u);
  EXPECT_EQ(overdraw[0][0].shaded, overdraw[1][0].visible);
  EXPECT_EQ(overdraw[1][0].shaded, overdraw[1][0].visible);
  // From behind, both are culled.
  EXPECT_EQ(overdraw[0][1], OverdrawCount());
  EXPECT_EQ(overdraw[1][1], OverdrawCount());
}

TEST(OverdrawRaster, holes_show_what_lies_behind_and_are_counted_apart) {
  const TestMesh far = quad(-0.1f);
  const TestMesh near = quad(0.1f);
  for (const double distance : {0.0, 1e6}) {
    const Views front = views_of({{0, 0, 1}}, 64, distance);
    std::vector<RasterPart> parts = {part_of(far), part_of(near)};
    const std::uint64_t whole = overdraw_raster(parts, front)[1][0].visible;
    EXPECT_EQ(whole % 2, 0u);
    parts[1].mask = testing::half_a_hole();
    OverdrawCounts counts = overdraw_raster(parts, front);
    EXPECT_EQ(counts[0][0], (OverdrawCount{whole, whole / 2, 0, 0}));
    EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, whole / 2}));
    std::swap(parts[0], parts[1]);  // near to far
    counts = overdraw_raster(parts, front);
    EXPECT_EQ(counts[0][0], (OverdrawCount{whole / 2, whole / 2, 0, whole / 2}));
    EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
    std::swap(parts[0].mask, parts[1].mask);  // a hole that is hidden costs nothing
    counts = overdraw_raster(parts, front);
    EXPECT_EQ(counts[0][0], (OverdrawCount{whole, whole, 0, 0}));
    EXPECT_EQ(counts[1][0], OverdrawCount());
    const OverdrawCounts alone = overdraw_raster(std::span(parts).last(1), front);
    EXPECT_EQ(alone[0][0], (OverdrawCount{alone[0][0].visible, alone[0][0].visible, 0, alone[0][0].visible}));
    EXPECT_GT(alone[0][0].visible, 1000u);
  }
}

TEST(OverdrawRaster, equally_near_fragments_do_not_pass_and_are_ties) {
  const OverdrawCount once = total(quad(0), views_of({{0, 0, 1}}));
  TestMesh other_diagonal = quad(0);
  other_diagonal.indices = {0, 1, 3, 0, 3, 2};
  const OverdrawCount twice = total(testing::joined(quad(0), other_diagonal), views_of({{0, 0, 1}}));
  EXPECT_EQ(twice.shaded, once.visible);
  EXPECT_EQ(twice.visible, once.visible);
  EXPECT_EQ(twice.ties, once.visible);
}

TEST(OverdrawRaster, a_triangle_drawn_twice_ties_however_its_corners_are_numbered) {
  for (const double distance : {0.0, 1.5, 1e6}) {  // from afar, the last bits of 1 / distance are worth a step of depth
    const TestMesh once = testing::soup(1, 3);
    TestMesh turned = once;
    turned.indices = {1, 2, 0};
    TestMesh flipped = once;
    flipped.indices = {0, 2, 1};
    for (const TestMesh& other : {turned, flipped}) {
      const OverdrawCount count = total(testing::joined(once, other), all_sides(200, distance), false);
      EXPECT_EQ(count.shaded, count.visible);
      EXPECT_EQ(count.ties, count.visible);
    }
  }
}

TEST(OverdrawRaster, a_convex_mesh_has_none_once_back_faces_are_culled) {
  const TestMesh ball = testing::shuffled(testing::sphere(24, 16), 1);
  for (const double distance : {0.0, 1.01, 3.0}) {
    // The sphere's rim may cross itself by the 1/256 pixel that its corners are snapped to.
    const OverdrawCount count = total(ball, all_sides(128, distance));
    EXPECT_LE(count.shaded, count.visible + count.visible / 10000) << distance;
    EXPECT_GT(total(ball, all_sides(128, distance), false).shaded, count.visible) << distance;
  }
}

TEST(OverdrawRaster, a_mirrored_part_shows_its_other_faces) {
  const TestMesh mesh = quad(0);
  RasterPart part = part_of(mesh);
  part.is_mirrored = true;
  EXPECT_EQ(total(overdraw_raster({&part, 1}, views_of({{0, 0, 1}}))).visible, 0u);
  EXPECT_GT(total(overdraw_raster({&part, 1}, views_of({{0, 0, -1}}))).visible, 0u);
}

TEST(OverdrawRaster, perspective_sees_the_near_quad_larger) {
  const TestMesh near = quad(0.5f, 0.5f);
  const TestMesh far = quad(-0.5f, 0.5f);
  const std::vector<RasterPart> parts = {part_of(far), part_of(near)};
  const OverdrawCounts close = overdraw_raster(parts, views_of({{0, 0, 1}}, 2048, 2));
  // Centre at the origin, radius r = sqrt(0.75): the camera is 2 r - 0.5 and 2 r + 0.5 away.
  const double r = std::sqrt(0.75);
  const double expected = std::pow((2 * r + 0.5) / (2 * r - 0.5), 2);
  const auto ratio = static_cast<double>(close[1][0].visible) / static_cast<double>(close[0][0].shaded);
  EXPECT_NEAR(ratio, expected, 0.02);
  EXPECT_EQ(close[0][0].visible, 0u);
}

TEST(OverdrawRaster, perspective_depth_is_along_the_axis_and_interpolated_right) {
  // Two slanted quads that cross along x = 0: from far away and from near, half of each is seen.
  const TestMesh up = {{{-1, -1, -1}, {1, -1, 1}, {-1, 1, -1}, {1, 1, 1}}, {0, 1, 2, 2, 1, 3}};
  const TestMesh down = {{{-1, -1, 1}, {1, -1, -1}, {-1, 1, 1}, {1, 1, -1}}, {0, 1, 2, 2, 1, 3}};
  const std::vector<RasterPart> parts = {part_of(up), part_of(down)};
  for (const double distance : {1.2, 2.0, 1000.0}) {
    const OverdrawCounts overdraw = overdraw_raster(parts, views_of({{0, 0, 1}}, 255, distance));
    // 255 pixels: the middle column lies on the crossing, where the first one drawn stays.
    const auto first = static_cast<double>(overdraw[0][0].visible);
    const auto second = static_cast<double>(overdraw[1][0].visible);
    EXPECT_LT(std::abs(first - second), 256) << distance;
    EXPECT_GT(first, 5000) << distance;
  }
}

TEST(OverdrawRaster, triangles_without_area_or_numbers_cover_nothing) {
  TestMesh mesh = quad(0);
  const OverdrawCount before = total(mesh, views_of({{0, 0, 1}}), false);
  mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
  mesh.positions.emplace_back(0, std::numeric_limits<float>::infinity(), 0);
  mesh.indices.insert(mesh.indices.begin(), {0, 1, 4, 5, 0, 1, 0, 0, 1, 0, 3, 3});
  EXPECT_EQ(total(mesh, views_of({{0, 0, 1}}), false), before);
  EXPECT_EQ(count_non_finite_triangles(part_of(mesh)), 2u);
  EXPECT_EQ(total({{{1, 1, 1}}, {0, 0, 0}}, views_of({{0, 0, 1}})), OverdrawCount());
  EXPECT_EQ(total(TestMesh(), views_of({{0, 0, 1}})), OverdrawCount());
}

TEST(OverdrawRaster, the_extremes_stay_in_the_picture) {
  const float most = std::numeric_limits<float>::max();
  const float least = std::numeric_limits<float>::denorm_min();
  for (const float scale : {most, least * 1000}) {
    TestMesh mesh = testing::sphere(16, 8);
    for (glm::vec3& position : mesh.positions) position *= scale;
    for (const double distance : {0.0, 1.01, 1e6}) EXPECT_GT(total(mesh, all_sides(64, distance)).visible, 20u * 1000);
  }
  EXPECT_GT(total(testing::sphere(16, 8), views_of({{0, 1, 0}}, 4096, 1.01)).visible, 4'000'000u);
}

// --- coverage
// ----------------------------------------------------------------------------------------------------------

TEST(OverdrawRaster, a_grid_covers_exactly_what_its_outline_covers) {
  TestMesh fine = testing::grid(37, 23);
  for (glm::vec3& position : fine.positions) position = {position.x / 37 * 2 - 1, position.y / 23 * 2 - 1, 0};
  for (const double distance : {0.0, 2.0}) {
    for (const int size : {16, 97, 256}) {
      const OverdrawCount whole = total(quad(0), views_of({{0, 0, 1}}, size, distance), false);
      const OverdrawCount parts = total(fine, views_of({{0, 0, 1}}, size, distance), false);
      EXPECT_EQ(parts.shaded, whole.shaded);
      EXPECT_EQ(parts.ties, 0u);
    }
  }
}

// --- against a reference
// -----------------------------------------------------------------------------------------------

TEST(OverdrawRaster, equals_the_reference) {
  const auto directions = all_sides().views;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const TestMesh one = crowd(seed);
    const TestMesh other = crowd(seed + 100);
    const std::vector<RasterPart> parts = {part_of(one), part_of(other, false)};
    const glm::dvec3 direction = directions[seed].direction;
    for (const std::size_t count : {1u, 2u}) {
      const auto some = std::span(parts).first(count);
      const std::vector<OverdrawCount> expected = overdraw_by_asking(some, direction, 16 + static_cast<int>(seed));
      const OverdrawCounts counted = overdraw_raster(some, views_of({direction}, 16 + static_cast<int>(seed)));
      for (std::size_t part = 0; part < count; ++part) {
        EXPECT_EQ(counted[part][0], expected[part]);
        EXPECT_GT(expected[part].ties, 0u);
      }
      EXPECT_GT(expected[0].shaded, expected[0].visible);
    }
  }
}

TEST(OverdrawRaster, the_same_counts_everywhere) {
  EXPECT_EQ(total(crowd(1), all_sides(256)), (OverdrawCount{519425, 347932, 402737}));
  EXPECT_EQ(total(crowd(1), all_sides(256, 1.5)), (OverdrawCount{343572, 237522, 272953}));
}

}  // namespace
}  // namespace foredraw::overdraw_raster_test
