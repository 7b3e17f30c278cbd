// A character from hundreds of sides: the exact rasteriser and rays tell the same, within what each says of its error.

#include "golden/corpus_run.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace foredraw::many_views_test {
namespace {

TEST(ManyViews, rays_agree_with_the_rasteriser_within_their_errors) {
  Registry registry;
  add_built_in_plugins(registry);
  if (registry.find("overdraw-embree") == nullptr) GTEST_SKIP() << "built without Embree";
  const Scene scene = testing::read_model(testing::project_file("benchmarks/corpus/animated/kaykit_knight.glb"));
  const std::string options = "(count=300, poses=4)";
  const Result result =
      testing::run_pipeline("", scene, 2, "overdraw-raster" + options + ", overdraw-embree" + options);
  ASSERT_FALSE(result.failed);
  const auto& figures = result.report.after.metrics.all();
  for (const std::string metric : {"ratio", "view-mean"}) {
    const Figure& exact = figures.at("overdraw-raster").at(metric);
    const Figure& rays = figures.at("overdraw-embree").at(metric);
    EXPECT_GT(exact.error, 0);
    EXPECT_LT(exact.error, 0.05 * exact.value()) << "or it would prove little";
    EXPECT_NEAR(rays.value(), exact.value(), std::min(exact.error, rays.error)) << metric;
    std::printf("%s: %.4f +- %.4f, by rays %.4f +- %.4f\n", metric.c_str(), exact.value(), exact.error, rays.value(),
                rays.error);
  }
}

}  // namespace
}  // namespace foredraw::many_views_test
