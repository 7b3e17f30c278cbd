// Where a plugin has qualities, a higher one is no worse in the plugin's own figure on any model: vertices that miss
// the cache, or fragments from the views that the order is made for.

#include "corpus_run.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace foredraw::qualities_test {
namespace {

struct Knob {
  const char* plugin;
  const char* stages;  ///< "{}" is the quality
  const char* measure;
  const char* metric;
};

constexpr Knob knobs[] = {
    {"lookahead", "weld, lookahead(quality={})", "vertex-cache", "acmr"},
    // Its own views: those of [views], at rest.
    {"occlusion-order", "weld, lookahead(quality=fast), occlusion-order(quality={})",
     "overdraw-raster(views=icosphere, size=128, poses=bind)", "ratio"},
};

double figure(const Scene& scene, const Knob& knob, const std::string& quality) {
  std::string stages = knob.stages;
  stages.replace(stages.find("{}"), 2, quality);
  const auto figures = testing::run_pipeline(stages, scene, 2, knob.measure).report.after.metrics.all();
  const Figure& measured = figures.begin()->second.at(knob.metric);
  return measured.numerator / *measured.denominator;
}

void expect_monotone(const std::string& model) {
  const Scene scene = testing::read_model(testing::project_file("benchmarks/corpus/" + model));
  for (const Knob& knob : knobs) {
    const double fast = figure(scene, knob, "fast");
    const double balanced = figure(scene, knob, "balanced");
    const double high = figure(scene, knob, "high");
    EXPECT_LE(balanced, fast) << knob.plugin << " on " << model;
    EXPECT_LE(high, balanced) << knob.plugin << " on " << model;
    std::printf("%s on %s: %.5f %.5f %.5f\n", knob.plugin, model.c_str(), fast, balanced, high);
  }
}

class Qualities : public ::testing::TestWithParam<const char*> {};

TEST_P(Qualities, AHigherOneIsNoWorse) { expect_monotone(GetParam()); }

std::string model_of(const ::testing::TestParamInfo<const char*>& info) {
  return std::filesystem::path(info.param).stem().string();
}

INSTANTIATE_TEST_SUITE_P(Small, Qualities,
                         ::testing::Values("static/spot.glb", "scenes/house.glb", "scenes/kenney_space_kit/rover.glb"),
                         model_of);
INSTANTIATE_TEST_SUITE_P(LargeModels, Qualities,
                         ::testing::Values("static/chess_board_notex.glb", "static/dispersion_test.glb",
                                           "static/dutch_ship_medium_notex.glb", "static/flight_helmet_notex.glb",
                                           "static/head.glb"),
                         model_of);

}  // namespace
}  // namespace foredraw::qualities_test
