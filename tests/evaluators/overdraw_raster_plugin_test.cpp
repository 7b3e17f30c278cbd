#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/overdraw/layers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace foredraw::overdraw_raster_plugin_test {
namespace {

using testing::all_sides;
using testing::crowd;
using testing::find;
using testing::part_of;
using testing::quad;
using testing::TestMesh;

Findings evaluate(const Scene& scene, const Settings& settings, int threads = 2) {
  return testing::evaluate(overdraw_raster_plugin(), scene, settings, threads);
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
  scene.materials[2].base_colour = Texture{};
  for (DrawId draw = 0; draw < 3; ++draw) scene.draws[draw].material = draw;
  const Findings findings = evaluate(scene, few_views);
  EXPECT_GT(find(findings, "ratio", 0)->numerator / *find(findings, "ratio", 0)->denominator, 1.1);
  EXPECT_EQ(find(findings, "ratio", 1), nullptr);
  EXPECT_EQ(find(findings, "ratio", 2), nullptr);
  EXPECT_EQ(find(findings, "blended-left-out", {})->numerator, 1);
  EXPECT_EQ(find(findings, "masked-left-out", {})->numerator, 1);
  ASSERT_EQ(findings.notes.size(), 2u);
  EXPECT_EQ(findings.notes[0].message, "left out because they are blended: 1 draw (Glass)");
  EXPECT_EQ(findings.notes[1].message,
            "left out because their holes are unknown: 1 draw (Leaves); its texture has no image of a known kind");

  Settings front = few_views;
  front["faces"] = std::string("front");
  const Findings culled = evaluate(scene, front);
  EXPECT_NEAR(find(culled, "ratio", 0)->numerator / *find(culled, "ratio", 0)->denominator, 1, 0.001);
}

TEST(OverdrawRasterPlugin, holes_are_measured) {
  Scene scene = testing::scene_of({testing::draw_of(quad(0), "Leaves")});
  scene.draws[0].material = 0;
  scene.materials.resize(1);
  scene.materials[0].alpha_mode = AlphaMode::mask;
  EXPECT_EQ(find(evaluate(scene, few_views), "discarded", {}), nullptr);
  scene.materials[0].alpha = 0.25f;  // one large hole
  const Findings findings = evaluate(scene, few_views);
  EXPECT_EQ(find(findings, "ratio", {})->numerator, 0);
  EXPECT_GT(find(findings, "discarded", {})->numerator, 1000);
  EXPECT_EQ(find(findings, "discarded", 0)->numerator, find(findings, "discarded", {})->numerator);
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

/// A change of one is within its errors exactly where a change of the other is.
TEST(OverdrawRasterPlugin, hidden_is_as_unsure_as_the_ratio) {
  const Scene scene = testing::scene_of(testing::shuffled(testing::torus(40, 20), 2));
  const Findings findings = evaluate(scene, few_views);
  const Measured& ratio = *find(findings, "ratio", {});
  const Measured& hidden = *find(findings, "hidden", {});
  EXPECT_GT(ratio.error, 0.001);
  EXPECT_EQ(hidden.numerator, ratio.numerator - *ratio.denominator);
  EXPECT_NEAR(hidden.error, ratio.error * *ratio.denominator, 1e-9 * hidden.numerator);
  EXPECT_LT(hidden.error, hidden.numerator);
  EXPECT_EQ(find(findings, "ties", {})->error, 0);
}

TEST(OverdrawRasterPlugin, what_has_no_overdraw_is_known_at_the_first_look) {
  const Findings findings = evaluate(testing::scene_of(testing::sphere(16, 8)), {{"error", 1e-4}});
  EXPECT_EQ(find(findings, "ratio", {})->error, 0);
  ASSERT_EQ(findings.notes.size(), 1u);
  EXPECT_EQ(findings.notes[0].message, "used 10 x 12 views of 64 x 64 pixels");
}

TEST(OverdrawRasterPlugin, details_name_what_can_have_no_overdraw) {
  Settings settings = few_views;
  settings["details"] = true;
  const Findings findings = evaluate(testing::scene_of({testing::draw_of(testing::sphere(16, 8), "ball"),
                                                        testing::draw_of(testing::torus(16, 8), "ring")}),
                                     settings);
  EXPECT_TRUE(std::ranges::any_of(findings.notes, [](const Note& note) {
    return note.message == "convex or nearly convex, so no order has a higher ratio than 1.001: 1 draw (ball)";
  }));
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
  EXPECT_EQ(findings.notes[1].message, "shade no fragment that ends up hidden, from any view: 1 draw (outer)");
  EXPECT_EQ(findings.notes[0].about.draw, 0u);
  EXPECT_TRUE(findings.notes[0].message.starts_with(
      "shades 100.0 % of the fragments that end up hidden; 1 of 2 clusters shade half of it: 1 ("))
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
}  // namespace foredraw::overdraw_raster_plugin_test
