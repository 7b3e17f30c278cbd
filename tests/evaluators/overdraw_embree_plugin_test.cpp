#include "../../evaluators/overdraw_embree/overdraw_embree.h"

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/measuring/overdraw_service.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace foredraw::overdraw_embree_plugin_test {
namespace {

using testing::find;
using testing::part_of;
using testing::TestMesh;

Views all_sides(int size = 64, double distance = 0, int count = 12) {
  return testing::all_sides(size, distance, count);
}

Findings evaluate(const Scene& scene, const Settings& settings, int threads = 2) {
  return testing::evaluate(overdraw_embree_plugin(), scene, settings, threads);
}

const Settings few_views = {
    {"views", std::string("fibonacci")}, {"count", std::int64_t{10}}, {"size", std::int64_t{64}}};

TEST(OverdrawEmbreePlugin, one_thread_counts_as_many_do) {
  const Scene scene = testing::scene_of(testing::shuffled(testing::torus(40, 20), 2));
  Settings settings = few_views;
  settings["samples"] = std::int64_t{3};
  const Findings one = evaluate(scene, settings, 1);
  for (const int threads : {2, 5}) {
    const Findings several = evaluate(scene, settings, threads);
    ASSERT_EQ(several.measured.size(), one.measured.size());
    for (std::size_t i = 0; i < one.measured.size(); ++i) {
      EXPECT_EQ(several.measured[i].numerator, one.measured[i].numerator);
      EXPECT_EQ(several.measured[i].denominator, one.measured[i].denominator);
      EXPECT_EQ(several.measured[i].error, one.measured[i].error);
    }
  }
}

TEST(OverdrawEmbreePlugin, traces_as_many_samples_as_asked_at_places_of_the_seed) {
  const Scene scene = testing::scene_of(testing::torus(40, 20));
  const auto visible = [&](std::int64_t samples, std::int64_t seed) {
    Settings settings = few_views;
    settings["samples"] = samples;
    settings["seed"] = seed;
    return *find(evaluate(scene, settings), "ratio", {})->denominator;
  };
  EXPECT_NEAR(visible(9, 0) / visible(1, 0), 9, 0.1);
  EXPECT_NE(visible(9, 0), visible(9, 1));
  EXPECT_EQ(visible(1, 0), visible(1, 1));
}

TEST(OverdrawEmbreePlugin, culls_back_faces_as_the_material_or_faces_says) {
  Scene scene = testing::scene_of(testing::sphere(16, 8));
  scene.materials.resize(1);
  scene.materials[0].double_sided = true;
  scene.draws[0].material = 0;
  const auto ratio = [&](const char* faces) {
    Settings settings = few_views;
    settings["faces"] = std::string(faces);
    const Findings findings = evaluate(scene, settings);
    return find(findings, "ratio", 0)->numerator / *find(findings, "ratio", 0)->denominator;
  };
  EXPECT_GT(ratio("material"), 1.1);
  EXPECT_EQ(ratio("front"), 1);
}

TEST(OverdrawEmbreePlugin, answers_for_measured_overdraw) {
  const TestMesh torus = testing::shuffled(testing::torus(24, 12), 1);
  const Scene scene = testing::scene_of(torus);
  const RasterPart part = part_of(torus);
  for (const int samples : {1, 4}) {
    const auto service = overdraw_embree_plugin().overdraw_service({{"samples", std::int64_t{samples}}});
    EXPECT_FALSE(service->can_capture());
    testing::RunFixture fixture;
    EXPECT_EQ(service->count(scene, subjects_of(scene)[0], all_sides(), fixture.run),
              overdraw_embree({&part, 1}, all_sides(), {samples, 0}));
  }
}

}  // namespace
}  // namespace foredraw::overdraw_embree_plugin_test
