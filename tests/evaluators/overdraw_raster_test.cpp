#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "overdraw_reference.h"
#include "support/meshes.h"
#include "support/painter.h"

#include <foredraw/analysis/view_sphere.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {
namespace {

using testing::part_of;
using testing::TestMesh;

Views views_of(std::vector<glm::dvec3> directions, int size = 64, double distance = 0) {
  Views views{{}, size};
  for (const glm::dvec3& direction : directions) views.views.push_back({direction, distance});
  return views;
}

Views all_sides(int size = 64, double distance = 0) {
  ViewSet set;
  set.views = "fibonacci";
  set.count = 20;
  set.size = size;
  if (distance > 0) set.distance = distance;
  return make_views(set);
}

/// Of all parts and views.
OverdrawCount total(const OverdrawCounts& counts) {
  OverdrawCount sum;
  for (const auto& part : counts) {
    for (const OverdrawCount& count : part) sum += count;
  }
  return sum;
}

OverdrawCount total(const TestMesh& mesh, const Views& views, bool culls_back_faces = true) {
  const RasterPart part = part_of(mesh, culls_back_faces);
  return total(overdraw_raster({&part, 1}, views));
}

/// A square that faces +Z.
TestMesh quad(float z, float half = 1) {
  return {{{-half, -half, z}, {half, -half, z}, {-half, half, z}, {half, half, z}}, {0, 1, 2, 2, 1, 3}};
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

/// Random triangles large enough to hide one another, each there twice so that there are ties.
TestMesh crowd(std::uint64_t seed) {
  Random random(seed);
  const auto coordinate = [&] { return static_cast<float>(random.unit()); };
  TestMesh mesh;
  for (std::uint32_t corner = 0; corner < 3 * 40; ++corner) {
    mesh.indices.push_back(corner);
    mesh.positions.push_back(glm::vec3{coordinate(), coordinate(), coordinate()});  // braces: one after the other
  }
  return testing::shuffled(testing::joined(mesh, mesh), seed);
}

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

// --- the plugin
// --------------------------------------------------------------------------------------------------------

Findings evaluate(const Scene& scene, const Settings& settings, int threads = 2) {
  const Plugin plugin = overdraw_raster_plugin();
  const Technique technique = plugin.create(settings);
  testing::RunFixture fixture;
  const Executor executor(threads);
  Run run{fixture.analyses, executor, fixture.findings, fixture.views};
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, run);
  return fixture.findings;
}

const Measured* find(const Findings& findings, const std::string& metric, std::optional<DrawId> draw) {
  for (const Measured& measured : findings.measured) {
    if (measured.metric == metric && measured.place.draw == draw) return &measured;
  }
  return nullptr;
}

const Settings few_views = {
    {"views", std::string("fibonacci")}, {"count", std::int64_t{10}}, {"size", std::int64_t{64}}};

TEST(OverdrawRasterPlugin, measures_each_draw_inside_its_mesh) {
  const TestMesh inner = testing::sphere(16, 8, 0.5f);
  const TestMesh outer = testing::sphere(16, 8, 1.0f);
  Scene scene = testing::scene_of({testing::draw_of(inner, "inner"), testing::draw_of(outer, "outer")});
  const Findings apart = evaluate(scene, few_views);
  EXPECT_NEAR(find(apart, "ratio", 0)->numerator / *find(apart, "ratio", 0)->denominator, 1, 0.001);

  scene.meshes[0].draws = {0, 1};
  scene.meshes.pop_back();
  scene.nodes.pop_back();
  const Findings together = evaluate(scene, few_views);
  EXPECT_GT(find(together, "ratio", 0)->numerator, 1000);
  EXPECT_EQ(find(together, "ratio", 0)->denominator, 0);  // hidden, but its fragments are paid for
  EXPECT_EQ(find(together, "view-mean", 0)->denominator, 0);
  EXPECT_EQ(find(together, "view-mean", 1)->denominator, 10);
}

TEST(OverdrawRasterPlugin, one_thread_counts_as_many_do) {
  const Scene scene = testing::scene_of(testing::shuffled(testing::torus(40, 20), 2));
  const Findings one = evaluate(scene, few_views, 1);
  for (const int threads : {2, 3, 8}) {
    const Findings several = evaluate(scene, few_views, threads);
    ASSERT_EQ(several.measured.size(), one.measured.size());
    for (std::size_t i = 0; i < one.measured.size(); ++i) {
      EXPECT_EQ(several.measured[i].numerator, one.measured[i].numerator);
      EXPECT_EQ(several.measured[i].denominator, one.measured[i].denominator);
      EXPECT_EQ(several.measured[i].error, one.measured[i].error);
    }
  }
}

TEST(OverdrawRasterPlugin, materials_decide_about_back_faces_and_blending) {
  Scene scene = testing::scene_of({testing::draw_of(testing::sphere(16, 8), "Shell"),
                                   testing::draw_of(quad(0), "Glass"), testing::draw_of(quad(0), "Leaves")});
  scene.materials.resize(3);
  scene.materials[0].double_sided = true;
  scene.materials[1].alpha_mode = AlphaMode::blend;
  scene.materials[2].alpha_mode = AlphaMode::mask;
  for (DrawId draw = 0; draw < 3; ++draw) scene.draws[draw].material = draw;
  const Findings findings = evaluate(scene, few_views);
  EXPECT_GT(find(findings, "ratio", 0)->numerator / *find(findings, "ratio", 0)->denominator, 1.1);
  EXPECT_EQ(find(findings, "ratio", 1), nullptr);
  EXPECT_NE(find(findings, "ratio", 2), nullptr);
  EXPECT_EQ(find(findings, "blended-left-out", {})->numerator, 1);
  ASSERT_EQ(findings.notes.size(), 2u);
  EXPECT_EQ(findings.notes[0].message, "left out as blended: 1 draw (Glass)");
  EXPECT_EQ(findings.notes[1].message, "drawn as if opaque, though masked: 1 draw (Leaves)");

  Settings front = few_views;
  front["faces"] = std::string("front");
  const Findings culled = evaluate(scene, front);
  EXPECT_NEAR(find(culled, "ratio", 0)->numerator / *find(culled, "ratio", 0)->denominator, 1, 0.001);
}

TEST(OverdrawRasterPlugin, parts_of_one_draw_are_summed_and_mirrored_ones_turned) {
  // A character whose two joints carry the same quad one above the other, both facing +Z.
  Scene scene = testing::scene_of(quad(0));
  scene.nodes.assign(2, Node());
  scene.nodes[0].mesh = 0;
  scene.nodes[1].mesh = 0;
  scene.nodes[1].transform.translation = {0, 2, 0};
  scene.nodes[1].transform.scale = {-1, 1, 1};
  scene.skins.resize(1);
  scene.skins[0].joints = {0, 1};
  const Findings findings = evaluate(scene, {{"views", std::string("axes")}, {"size", std::int64_t{512}}});
  EXPECT_EQ(find(findings, "view-mean", 0)->denominator, 1);  // +Z alone of the 6
  const double pixels = 2 * std::pow(2 * 256 / std::sqrt(5.0), 2);
  EXPECT_NEAR(*find(findings, "ratio", 0)->denominator / pixels, 1, 0.01);
}

TEST(OverdrawRasterPlugin, answers_for_measured_overdraw) {
  const Scene scene = testing::scene_of(testing::torus(24, 12));
  const Plugin plugin = overdraw_raster_plugin();
  const auto service = plugin.overdraw_service({});
  testing::RunFixture fixture;
  const OverdrawCounts overdraw = service->count(scene, subjects_of(scene)[0], all_sides(), fixture.run);
  const TestMesh torus = testing::torus(24, 12);
  const RasterPart part = part_of(torus);
  const OverdrawCounts expected = overdraw_raster({&part, 1}, all_sides());
  EXPECT_EQ(overdraw, expected);
}

/// The scene with the triangles of its only draw in another order.
Scene with_order(const TestMesh& mesh, std::span<const std::uint32_t> order) {
  TestMesh ordered{mesh.positions, {}};
  for (const std::uint32_t t : order) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) ordered.indices.push_back(mesh.indices[3 * t + corner]);
  }
  return testing::scene_of(ordered);
}

TEST(OverdrawRasterPlugin, layers_count_any_order_as_drawing_it_does) {
  const TestMesh mesh = testing::joined(testing::torus(24, 12), testing::joined(crowd(3), quad(0)));
  const Scene scene = testing::scene_of(mesh);
  const auto service = overdraw_raster_plugin().overdraw_service({{"faces", std::string("front")}});
  ASSERT_TRUE(service->can_capture());
  testing::RunFixture fixture;
  const RasterPart part = part_of(mesh);
  for (const double distance : {0.0, 2.0}) {
    const Views views = all_sides(64, distance);
    const auto layers = service->capture({&part, 1}, views, fixture.run);
    ASSERT_TRUE(layers);
    EXPECT_FALSE(service->capture({&part, 1}, views, fixture.run, layers->bytes() - 1));
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const std::vector<std::uint32_t> order = testing::random_order(mesh.indices.size() / 3, seed);
      const Scene drawn = with_order(mesh, order);
      const OverdrawCounts counts = service->count(drawn, subjects_of(drawn)[0], views, fixture.run);
      EXPECT_EQ(count_overdraw_by_view(*layers, order), counts[0]);
    }
  }
}

TEST(OverdrawRasterPlugin, says_where_it_looks_from_where_orders_were_optimised_for) {
  const Scene scene = testing::scene_of(quad(0));
  testing::RunFixture fixture;
  ViewSet axes;
  axes.views = "axes";
  fixture.views = make_views(axes);
  const Technique technique = overdraw_raster_plugin().create({{"views", std::string("axes")}});
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, fixture.run);
  ASSERT_EQ(fixture.findings.notes.size(), 1u);
  EXPECT_EQ(fixture.findings.notes[0].code, "same-views");
  EXPECT_TRUE(evaluate(scene, few_views).notes.empty());
}

TEST(OverdrawRasterPlugin, a_wanted_error_is_reached_and_true) {
  const Scene scene =
      testing::scene_of(testing::joined(testing::torus(24, 12), testing::sphere(16, 8, 0.8f, {0, 0.5f, 0})));
  const auto ratio = [&](const Settings& settings) {
    const Findings findings = evaluate(scene, settings);
    const Measured* measured = find(findings, "ratio", {});
    return std::pair(measured->numerator / *measured->denominator, measured->error);
  };
  const double truth = ratio({{"views", std::string("2562")}, {"size", std::int64_t{512}}}).first;
  int far = 0;
  for (std::int64_t seed = 0; seed < 20; ++seed) {
    const auto [value, error] = ratio({{"error", 0.003}, {"seed", seed}});
    EXPECT_LE(error, 0.003);
    EXPECT_GT(error, 0);
    far += std::abs(value - truth) > 0.003 ? 1 : 0;
  }
  EXPECT_LE(far, 1);
  EXPECT_NE(ratio({{"error", 0.003}, {"seed", std::int64_t{1}}}), ratio({{"error", 0.003}, {"seed", std::int64_t{2}}}));
}

TEST(OverdrawRasterPlugin, what_has_no_overdraw_is_known_at_the_first_look) {
  const Findings findings = evaluate(testing::scene_of(testing::sphere(16, 8)), {{"error", 1e-4}});
  EXPECT_EQ(find(findings, "ratio", {})->error, 0);
  ASSERT_EQ(findings.notes.size(), 1u);
  EXPECT_EQ(findings.notes[0].message, "looked from 10 x 12 views of 64 x 64 pixels");
}

TEST(OverdrawRasterPlugin, details_tell_who_causes_the_overdraw) {
  Scene scene = testing::scene_of({testing::draw_of(testing::sphere(16, 8, 0.5f), "inner"),
                                   testing::draw_of(testing::sphere(16, 8, 1.0f), "outer")});
  scene.meshes[0].draws = {0, 1};
  scene.meshes.pop_back();
  scene.nodes.pop_back();
  scene.draws[0].levels[0].orders[0].clusters =
      Clusters{{0, 4, static_cast<std::uint32_t>(scene.draws[0].levels[0].orders[0].triangle_count())}};
  Settings settings = few_views;
  settings["details"] = true;
  const Findings findings = evaluate(scene, settings);
  ASSERT_EQ(findings.notes.size(), 2u);
  EXPECT_EQ(findings.notes[1].message, "nothing that these shade is hidden, from any view: 1 draw (outer)");
  EXPECT_EQ(findings.notes[0].place.draw, 0u);
  EXPECT_TRUE(findings.notes[0].message.starts_with(
      "shades 100.0 % of what is hidden in the end; half of it is shaded by 1 of 2 clusters: 1 ("))
      << findings.notes[0].message;
  const double visible = *find(findings, "ratio", {})->denominator;
  const double hidden = find(findings, "hidden", {})->numerator;
  EXPECT_GT(hidden, 1000);
  EXPECT_EQ(find(findings, "hidden", 0)->numerator, hidden);
  EXPECT_EQ(find(findings, "shaded-times.1", {})->numerator, visible - hidden);
  EXPECT_EQ(find(findings, "shaded-times.2", {})->numerator, hidden);
  EXPECT_EQ(find(findings, "shaded-times.8", {})->numerator, 0);
}

TEST(OverdrawRasterPlugin, a_view_set_that_can_not_be_made_is_refused) {
  const Plugin plugin = overdraw_raster_plugin();
  EXPECT_THROW(plugin.create({{"views", std::string("icosphere")}, {"count", std::int64_t{100}}}),
               std::invalid_argument);
  EXPECT_NO_THROW(plugin.create({{"views", std::string("42")}}));
  EXPECT_NO_THROW(plugin.create({{"views", std::string("axes")}}));
}

}  // namespace
}  // namespace foredraw
