// Orders for animated characters, from file to figures.

#include "corpus_run.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::animated_orders_test {
namespace {

struct Told {
  double excess = 0;  ///< overdraw above 1, of the whole scene
  std::size_t orders = 0;
  std::string failures;
};

/// Made for 12 poses from 42 sides; measured from other sides.
Told told(const std::string& model, const std::string& stages, int measured_poses) {
  const std::string text = "pipeline = 1\nstages = [" + stages + R"(]
measure = [{ use = "overdraw-raster", views = "random", count = 40, distance = 3, size = 128, faces = "front", poses = )" +
                           std::to_string(measured_poses) + R"( }]
[views]
views = "icosphere"
count = 42
size = 96
[poses]
poses = 12
[services]
overdraw = { use = "overdraw-raster", faces = "front" }
)";
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto pipeline = parse_file(text, "animated.toml", diagnostics);
  const Scene scene = testing::read_model(testing::project_file("benchmarks/corpus/animated/" + model + ".glb"));
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(2);
  Analyses analyses(image_decoder({}));
  const Result result = optimize(*plan, scene, {executor, analyses});
  Told told;
  told.excess = result.report.after.metrics.find("overdraw-raster", "ratio")->value() - 1;
  for (const Diagnostic& diagnostic : result.report.diagnostics) told.failures += diagnostic.message;
  for (const Draw& draw : result.scene.draws) told.orders = std::max(told.orders, draw.levels[0].orders.size());
  return told;
}

constexpr int the_same = 12, between_the_keys = 7;
const std::string clustered = R"("weld", "tipsify", { use = "linear-clusters", growth = 1.2 }, )";

TEST(AnimatedOrders, KMeansLeavesLessThanTheDotRule) {
  // Geometric guesses at rest against what is measured in poses; other poses and sides than those that were measured.
  for (const char* model : {"cesium_man_notex", "quaternius_smooth_female_dress"}) {
    const Told guessed = told(model, clustered + R"({ use = "dot-rule", check = false })", between_the_keys);
    const Told five = told(model, clustered + R"({ use = "animated-kmeans", k = 5 })", between_the_keys);
    const Told one = told(model, clustered + R"({ use = "animated-kmeans", k = 1 })", between_the_keys);
    EXPECT_LT(five.excess, 0.6 * guessed.excess) << model;
    EXPECT_LT(five.excess, one.excess) << model;
    EXPECT_EQ(five.orders, 5u) << model;
    EXPECT_EQ(five.failures, "");
  }
}

TEST(AnimatedOrders, EachClipMayHaveASetOfItsOwn) {
  const Told joint = told("fox", clustered + R"({ use = "animated-kmeans", k = 3, restarts = 8 })", the_same);
  const Told single =
      told("fox", clustered + R"({ use = "animated-kmeans", k = 3, restarts = 8, clips = "single" })", the_same);
  EXPECT_EQ(joint.orders, 3u);
  EXPECT_EQ(single.orders, 9u) << "three clips";
  EXPECT_LT(single.excess, joint.excess);
  const Told too_many = told("fox", clustered + R"({ use = "animated-kmeans", k = 86, clips = "single" })", the_same);
  EXPECT_EQ(too_many.orders, 1u);
  EXPECT_NE(too_many.failures.find("lower k to 85"), std::string::npos) << too_many.failures;
}

}  // namespace
}  // namespace foredraw::animated_orders_test
