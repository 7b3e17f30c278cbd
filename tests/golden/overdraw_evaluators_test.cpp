// Real models: whoever counts overdraw is near to the exact rasteriser, nearer than the choice of views leaves it.

#include "corpus_run.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::overdraw_evaluators_test {
namespace {

/// Evaluators that count overdraw otherwise, and that this machine can run.
std::vector<std::string> others() {
  Registry registry;
  add_built_in_plugins(registry);
  std::vector<std::string> names;
  for (const Plugin* plugin : registry.all()) {
    if (!plugin->overdraw_service || plugin->card.name == "overdraw-raster") continue;
    if (plugin->unavailable && plugin->unavailable()) continue;
    names.push_back(plugin->card.name);
  }
  return names;
}

double value(const Figure& figure) { return figure.numerator / *figure.denominator; }

void expect_near_to_the_exact_one(const std::vector<std::string>& all_options) {
  const std::vector<std::string> evaluators = others();
  if (evaluators.empty()) GTEST_SKIP() << "overdraw-raster alone can run here";
  for (const std::string model : {"static/spot.glb", "animated/kaykit_knight.glb", "scenes/house.glb"}) {
    const Scene scene = testing::read_model(testing::project_file("benchmarks/corpus/" + model));
    for (const std::string& options : all_options) {
      std::string measure = "overdraw-raster" + options;
      for (const std::string& evaluator : evaluators) measure += ", " + evaluator + options;
      const auto figures = testing::run_pipeline("", scene, 2, measure).report.after.metrics.all();
      const auto& exact = figures.at("overdraw-raster");
      for (const std::string& evaluator : evaluators) {
        for (const std::string metric : {"ratio", "view-mean"}) {
          const Figure& expected = exact.at(metric);
          // Surfaces in one plane, cut into different triangles, tie or pass by the last bit of their depths, which
          // each evaluator rounds in its own way; the house and the knight have many.
          EXPECT_NEAR(value(figures.at(evaluator).at(metric)), value(expected), expected.error / 4)
              << evaluator << options << ' ' << metric << " of " << model;
        }
        const double pixels = *exact.at("ratio").denominator;
        EXPECT_NEAR(*figures.at(evaluator).at("ratio").denominator / pixels, 1, 1e-4) << evaluator << ' ' << model;
        if (!figures.at(evaluator).contains("discarded")) continue;  // nothing is, or it is not counted
        EXPECT_NEAR(figures.at(evaluator).at("discarded").numerator / exact.at("discarded").numerator, 1, 0.01)
            << model;
      }
    }
  }
}

TEST(OverdrawEvaluators, AreNearToTheExactOneOnRealModels) {
  expect_near_to_the_exact_one(
      {"(count=40, size=128, poses=2)", "(distance=1.5, faces=front, count=40, size=128, poses=bind)"});
}

TEST(OverdrawEvaluators, AreNearToTheExactOneFromManySides) {
  expect_near_to_the_exact_one({"(poses=2)", "(distance=1.5, faces=front, size=128, poses=bind)"});
}

}  // namespace
}  // namespace foredraw::overdraw_evaluators_test
