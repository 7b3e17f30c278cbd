#include "../../evaluators/overdraw_embree/overdraw_embree.h"
#include "../../evaluators/overdraw_embree/traced_parts.h"

#include "overdraw_embree_reference.h"
#include "support/meshes.h"
#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace foredraw::overdraw_embree_test {
namespace {

using testing::part_of;
using testing::quad;
using testing::TestMesh;
using testing::total;
using testing::views_of;

Views all_sides(int size = 64, double distance = 0, int count = 12) {
  return testing::all_sides(size, distance, count);
}

Views from(const glm::dvec3& direction, int size = 64, double distance = 0) { return {{{direction, distance}}, size}; }

OverdrawCount total(const TestMesh& mesh, const Views& views, bool culls_back_faces = true,
                    const OverdrawEmbreeOptions& options = {}) {
  const RasterPart part = part_of(mesh, culls_back_faces);
  return total(overdraw_embree({&part, 1}, views, options));
}

/// What the rasteriser counts, whose corners are snapped to 1/256 pixel.
OverdrawCount drawn(const TestMesh& mesh, const Views& views, bool culls_back_faces = true) {
  const RasterPart part = part_of(mesh, culls_back_faces);
  OverdrawCount sum;
  for (const OverdrawCount& count :
       testing::painted({&part, 1}, views, testing::rising_order(mesh.indices.size() / 3))) {
    sum += count;
  }
  return sum;
}

// --- what is counted

TEST(OverdrawEmbree, parallel_quads_pass_as_often_as_the_order_lets_them) {
  const auto stack = [](std::vector<float> depths) {
    TestMesh mesh;
    for (const float z : depths) mesh = testing::joined(mesh, quad(z));
    return total(mesh, from({0, 0, 1}));
  };
  const OverdrawCount inside_out = stack({-0.4f, -0.2f, 0, 0.2f, 0.4f});
  EXPECT_GT(inside_out.visible, 1500u);
  EXPECT_EQ(inside_out.shaded, 5 * inside_out.visible);
  EXPECT_EQ(inside_out.ties, 0u);
  const OverdrawCount outside_in = stack({0.4f, 0.2f, 0, -0.2f, -0.4f});
  EXPECT_EQ(outside_in, (OverdrawCount{inside_out.visible, inside_out.visible, 0}));
  // Passing are -0.2, 0 and 0.4; the second 0 ties.
  EXPECT_EQ(stack({-0.2f, -0.4f, 0, 0, 0.4f, 0.2f}),
            (OverdrawCount{3 * inside_out.visible, inside_out.visible, inside_out.visible}));
}

TEST(OverdrawEmbree, nested_shells_cost_what_they_cover) {
  TestMesh inside_out, outside_in;
  double covered = 0;
  for (int i = 0; i < 6; ++i) {
    const float radius = 0.9f + 0.02f * static_cast<float>(i);
    inside_out = testing::joined(inside_out, testing::sphere(64, 32, radius));
    outside_in = testing::joined(testing::sphere(64, 32, radius), outside_in);
    covered += radius * radius;
  }
  const OverdrawCount most = total(inside_out, all_sides(128));
  EXPECT_NEAR(static_cast<double>(most.shaded) / static_cast<double>(most.visible), covered, 0.01);
  const OverdrawCount least = total(outside_in, all_sides(128));
  EXPECT_EQ(least.shaded, least.visible);
}

TEST(OverdrawEmbree, each_part_has_its_own_fragments) {
  const TestMesh far = quad(-0.1f);
  const TestMesh near = quad(0.1f);
  const std::vector<RasterPart> parts = {part_of(far), part_of(near)};
  const OverdrawCounts overdraw = overdraw_embree(parts, {{{{0, 0, 1}}, {{0, 0, -1}}}, 64});
  ASSERT_EQ(overdraw[0].size(), 2u);
  EXPECT_EQ(overdraw[0][0].visible, 0u);
  EXPECT_GT(overdraw[0][0].shaded, 1500u);
  EXPECT_EQ(overdraw[0][0].shaded, overdraw[1][0].visible);
  EXPECT_EQ(overdraw[1][0].shaded, overdraw[1][0].visible);
  // From behind, both are culled.
  EXPECT_EQ(overdraw[0][1], OverdrawCount());
  EXPECT_EQ(overdraw[1][1], OverdrawCount());
}

TEST(OverdrawEmbree, holes_show_what_lies_behind_and_are_counted_apart) {
  const TestMesh far = quad(-0.1f);
  const TestMesh near = quad(0.1f);
  for (const double distance : {0.0, 1e6}) {
    const Views front = views_of({{0, 0, 1}}, 64, distance);
    std::vector<RasterPart> parts = {part_of(far), part_of(near)};
    const std::uint64_t whole = overdraw_embree(parts, front)[1][0].visible;
    EXPECT_EQ(whole % 2, 0u);
    parts[1].mask = testing::half_a_hole();
    OverdrawCounts counts = overdraw_embree(parts, front);
    EXPECT_EQ(counts[0][0], (OverdrawCount{whole, whole / 2, 0, 0}));
    EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, whole / 2}));
    std::swap(parts[0], parts[1]);  // near to far
    counts = overdraw_embree(parts, front);
    EXPECT_EQ(counts[0][0], (OverdrawCount{whole / 2, whole / 2, 0, whole / 2}));
    EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
    std::swap(parts[0].mask, parts[1].mask);  // a hole that is hidden costs nothing
    counts = overdraw_embree(parts, front);
    EXPECT_EQ(counts[0][0], (OverdrawCount{whole, whole, 0, 0}));
    EXPECT_EQ(counts[1][0], OverdrawCount());
    const OverdrawCounts alone = overdraw_embree(std::span(parts).last(1), front);
    EXPECT_EQ(alone[0][0], (OverdrawCount{alone[0][0].visible, alone[0][0].visible, 0, alone[0][0].visible}));
    EXPECT_GT(alone[0][0].visible, 1000u);
  }
}

TEST(OverdrawEmbree, a_triangle_drawn_twice_ties_however_its_corners_are_numbered) {
  for (const double distance : {0.0, 1.5, 1e6}) {
    const TestMesh once = testing::soup(1, 3);
    for (const std::vector<std::uint32_t>& indices : {std::vector<std::uint32_t>{1, 2, 0}, {0, 2, 1}}) {
      const OverdrawCount count =
          total(testing::joined(once, {once.positions, indices}), all_sides(200, distance), false);
      EXPECT_GT(count.visible, 1000u);
      EXPECT_EQ(count.shaded, count.visible);
      EXPECT_EQ(count.ties, count.visible);
    }
  }
}

TEST(OverdrawEmbree, faces_are_culled_as_the_part_says) {
  const TestMesh mesh = quad(0);
  const Views front = from({0, 0, 1});
  const Views back = from({0, 0, -1});
  const auto seen = [&](const Views& views, bool culls, bool is_mirrored) {
    const RasterPart part{mesh.positions, mesh.indices, culls, is_mirrored};
    return total(overdraw_embree({&part, 1}, views)).visible;
  };
  const std::uint64_t whole = seen(front, true, false);
  EXPECT_GT(whole, 1500u);
  EXPECT_EQ(seen(back, true, false), 0u);
  EXPECT_EQ(seen(front, true, true), 0u);
  EXPECT_EQ(seen(back, true, true), whole);
  for (const bool is_mirrored : {false, true}) {
    EXPECT_EQ(seen(front, false, is_mirrored), whole);
    EXPECT_EQ(seen(back, false, is_mirrored), whole);
  }
}

TEST(OverdrawEmbree, triangles_without_area_or_numbers_cover_nothing) {
  TestMesh mesh = quad(0);
  const OverdrawCount before = total(mesh, from({0, 0, 1}), false);
  mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
  mesh.positions.emplace_back(0, std::numeric_limits<float>::infinity(), 0);
  mesh.indices.insert(mesh.indices.begin(), {0, 1, 4, 5, 0, 1, 0, 0, 1, 0, 3, 3});
  EXPECT_EQ(total(mesh, from({0, 0, 1}), false), before);
  EXPECT_EQ(total({{{1, 1, 1}}, {0, 0, 0}}, from({0, 0, 1})), OverdrawCount());
  EXPECT_EQ(total({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {0, 1, 2}}, from({0, 0, 1})), OverdrawCount());
  EXPECT_EQ(total({{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, {0, 1, 2}}, from({0, 0, 1}), false), OverdrawCount());
  EXPECT_EQ(total(TestMesh(), all_sides()), OverdrawCount());
  EXPECT_TRUE(overdraw_embree({}, all_sides()).empty());
}

TEST(OverdrawEmbree, one_triangle_covers_its_area) {
  const TestMesh mesh = {{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}}, {0, 1, 2}};
  const double expected = 2 / std::pow(std::sqrt(2.0), 2) * 512 * 512;
  EXPECT_NEAR(static_cast<double>(total(mesh, from({0, 0, 1}, 1024)).visible) / expected, 1, 0.002);
}

TEST(OverdrawEmbree, no_scale_is_too_large_or_too_small) {
  const TestMesh mesh = testing::shuffled(testing::torus(24, 12), 1);
  const OverdrawCount expected = total(mesh, all_sides());
  EXPECT_GT(expected.shaded, expected.visible);
  for (const float scale : {0x1p66f, 0x1p-66f}) {
    TestMesh scaled = mesh;
    for (glm::vec3& position : scaled.positions) position *= scale;
    EXPECT_EQ(total(scaled, all_sides()), expected);
  }
  for (const float scale : {std::numeric_limits<float>::max() / 2, std::numeric_limits<float>::denorm_min() * 1000}) {
    TestMesh scaled = testing::sphere(16, 8);
    for (glm::vec3& position : scaled.positions) position *= scale;
    for (const double distance : {0.0, 1.01, 1e6}) EXPECT_GT(total(scaled, all_sides(64, distance)).visible, 15'000u);
  }
}

// --- each sample in one triangle of a surface, in no two and never in none

TEST(OverdrawEmbree, edges_and_corners_on_samples_belong_to_one_triangle) {
  // Rows, columns and diagonals of samples lie on the spokes, and the middle one on the hub.
  TestMesh fan = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}}, {}};
  for (std::uint32_t i = 0; i < 8; ++i) fan.indices.insert(fan.indices.end(), {0, 1 + i, 1 + (i + 1) % 8});
  TestMesh other_diagonal = quad(0);
  other_diagonal.indices = {0, 1, 3, 0, 3, 2};
  for (const double distance : {0.0, 2.0}) {
    for (const int size : {32, 33, 97}) {
      const Views views = from({0, 0, 1}, size, distance);
      const OverdrawCount whole = total(quad(0), views);
      EXPECT_EQ(whole.shaded, whole.visible);
      EXPECT_EQ(whole.ties, 0u);
      EXPECT_EQ(total(other_diagonal, views), whole);
      EXPECT_EQ(total(fan, views), whole);
      EXPECT_EQ(total(fan, from({0, 0, -1}, size, distance), false), whole);
    }
  }
}

TEST(OverdrawEmbree, a_grid_covers_exactly_what_its_outline_covers) {
  TestMesh fine = testing::grid(37, 23);
  for (glm::vec3& position : fine.positions) position = {position.x / 37 * 2 - 1, position.y / 23 * 2 - 1, 0};
  for (const double distance : {0.0, 2.0}) {
    for (const int size : {16, 97, 256}) {
      const OverdrawCount whole = total(quad(0), from({0, 0, 1}, size, distance));
      EXPECT_EQ(total(fine, from({0, 0, 1}, size, distance)), whole);
    }
  }
}

TEST(OverdrawEmbree, a_convex_mesh_is_hit_once_and_from_behind_as_often) {
  // Down to triangles of a quarter of a pixel.
  for (const auto& [slices, stacks] : {std::pair(7u, 5u), std::pair(100u, 60u), std::pair(400u, 200u)}) {
    const TestMesh ball = testing::shuffled(testing::sphere(slices, stacks), 1);
    for (const double distance : {0.0, 1.01, 3.0, 1e6}) {
      const Views views = all_sides(100, distance, 6);
      const OverdrawCount front = total(ball, views);
      EXPECT_GT(front.visible, 4000u);
      EXPECT_EQ(front.shaded, front.visible);
      EXPECT_EQ(front.ties, 0u);
      TestMesh inverted = ball;
      for (std::size_t i = 0; i < inverted.indices.size(); i += 3)
        std::swap(inverted.indices[i], inverted.indices[i + 1]);
      EXPECT_EQ(total(inverted, views).visible, front.visible);
      EXPECT_EQ(total(ball, views, false).visible, front.visible);
    }
  }
}

// --- against references

TEST(OverdrawEmbree, equals_what_every_sample_asked_of_every_triangle_says) {
  const auto directions = all_sides().views;
  OverdrawCount sum;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const TestMesh mesh = testing::tangle(seed, seed % 2 == 0);
    const TestMesh other = testing::soup(20, seed);
    const std::vector<RasterPart> parts = {part_of(mesh, seed % 3 != 0),
                                           {other.positions, other.indices, true, seed % 2 == 0}};
    for (const double distance : {0.0, 1.01, 3.0, 1e5}) {
      for (const int samples : {1, 3}) {
        View view = directions[seed];
        view.distance = distance;
        const int size = seed % 2 == 0 ? 16 : 45;
        const auto expected = overdraw_by_asking(parts, view, size, {samples, seed});
        const OverdrawCounts counts = overdraw_embree(parts, {{view}, size}, {samples, seed});
        for (std::size_t part = 0; part < 2; ++part) {
          EXPECT_EQ(counts[part][0], expected[part]) << seed << ' ' << distance;
          sum += expected[part];
        }
      }
    }
  }
  EXPECT_GT(sum.visible, 15'000u);
  EXPECT_GT(sum.shaded, sum.visible + sum.visible / 10);
  EXPECT_GT(sum.ties, sum.visible / 10);
}

TEST(OverdrawEmbree, agrees_with_the_rasteriser_but_for_samples_next_to_an_edge) {
  const TestMesh mesh = testing::joined(testing::shuffled(testing::torus(80, 40), 1),
                                        testing::shuffled(testing::sphere(40, 20, 0.9f, {0.4f, 0.2f, 0}), 2));
  for (const double distance : {0.0, 2.0}) {
    const Views views = all_sides(256, distance);
    const OverdrawCount traced = total(mesh, views);
    const OverdrawCount drawn_ones = drawn(mesh, views);
    EXPECT_GT(traced.shaded, traced.visible + traced.visible / 10);
    // Found are 1.2e-5 at most. A corner moves by 1/512 pixel, which decides about some samples next to silhouettes.
    const auto near = [](std::uint64_t a, std::uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); };
    EXPECT_NEAR(near(traced.visible, drawn_ones.visible), 1, 5e-5);
    EXPECT_NEAR(near(traced.shaded, drawn_ones.shaded), 1, 5e-5);
  }
}

TEST(OverdrawEmbree, the_same_counts_everywhere) {
  const TestMesh mesh = testing::tangle(1, true);
  EXPECT_EQ(total(mesh, all_sides(256), false), (OverdrawCount{233072, 153039, 308076}));
  EXPECT_EQ(total(mesh, all_sides(256, 1.5), false), (OverdrawCount{151428, 102152, 209717}));
  EXPECT_EQ(total(mesh, all_sides(64, 1.5), false, {8, 1}), (OverdrawCount{75597, 51031, 104720}));
}

TEST(OverdrawEmbree, one_sample_lies_in_the_middle_and_more_are_spread_evenly) {
  EXPECT_EQ(SamplePattern(7, 3, 5, 1)[0].x, SamplePattern::steps / 2);
  EXPECT_EQ(SamplePattern(7, 3, 5, 1)[0].y, SamplePattern::steps / 2);
  std::vector<int> fields(16);
  double x = 0, y = 0;
  for (std::uint32_t pixel = 0; pixel < 1000; ++pixel) {
    const SamplePattern pattern(7, pixel % 50, pixel / 50, 64);
    std::vector<int> of_pixel(16);
    for (int sample = 0; sample < 64; ++sample) {
      const auto place = pattern[sample];
      ASSERT_LT(static_cast<unsigned>(place.x), unsigned{SamplePattern::steps});
      ASSERT_LT(static_cast<unsigned>(place.y), unsigned{SamplePattern::steps});
      ++of_pixel[static_cast<std::size_t>(place.x / (SamplePattern::steps / 4) * 4 +
                                          place.y / (SamplePattern::steps / 4))];
    }
    // 4 are expected; random places leave one of 16 fields empty in every fourth pixel.
    for (std::size_t field = 0; field < 16; ++field) {
      EXPECT_GE(of_pixel[field], 1);
      EXPECT_LE(of_pixel[field], 8);
      fields[field] += of_pixel[field];
    }
    x += pattern[0].x;
    y += pattern[0].y;
  }
  for (const int field : fields) EXPECT_NEAR(field, 4000, 200);
  EXPECT_NEAR(x / 1000 / SamplePattern::steps, 0.5, 0.03);
  EXPECT_NEAR(y / 1000 / SamplePattern::steps, 0.5, 0.03);
  EXPECT_NE(SamplePattern(7, 3, 5, 2)[0].x, SamplePattern(8, 3, 5, 2)[0].x);
  EXPECT_NE(SamplePattern(7, 3, 5, 2)[0].x, SamplePattern(7, 5, 3, 2)[0].x);
}

TEST(OverdrawEmbree, more_samples_are_nearer_to_a_finer_picture) {
  const TestMesh mesh = testing::joined(testing::shuffled(testing::torus(60, 30), 1), testing::sphere(20, 10, 0.7f));
  const RasterPart part = part_of(mesh);
  const Views coarse = all_sides(32);
  const auto ratio = [](const OverdrawCount& count) {
    return static_cast<double>(count.shaded) / static_cast<double>(count.visible);
  };
  std::vector<double> truth;
  for (const View& view : coarse.views) truth.push_back(ratio(drawn(mesh, {{view}, 1024})));
  const auto error = [&](int samples) {
    const auto counts = overdraw_embree({&part, 1}, coarse, {samples, 3})[0];
    double sum = 0;
    for (std::size_t view = 0; view < counts.size(); ++view) sum += std::abs(ratio(counts[view]) - truth[view]);
    return sum / static_cast<double>(counts.size());
  };
  const double one = error(1);
  EXPECT_GT(one, 0.002);
  EXPECT_LT(error(16), one / 5);
}

TEST(OverdrawEmbree, many_threads_may_ask_the_same_tree) {
  const TestMesh mesh = testing::tangle(2, false);
  const RasterPart part = part_of(mesh, false);
  const Views views = all_sides(64);
  const OverdrawCounts expected = overdraw_embree({&part, 1}, views, {2, 1});
  const Executor executor(2);
  const TracedParts traced({&part, 1});
  std::vector<OverdrawCount> counts(views.views.size());
  executor.for_each(counts.size(), [&](std::size_t i) { counts[i] = traced.count(views.views[i], 64, {2, 1})[0]; });
  EXPECT_EQ(counts, expected[0]);
}

}  // namespace
}  // namespace foredraw::overdraw_embree_test
