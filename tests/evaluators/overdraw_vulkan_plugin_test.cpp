#include "../../evaluators/overdraw_vulkan/overdraw_vulkan.h"

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/measuring/overdraw_service.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw::overdraw_vulkan_plugin_test {
namespace {

using testing::find;

class OverdrawVulkanPlugin : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const auto reason = overdraw_vulkan_plugin().unavailable()) GTEST_SKIP() << *reason;
  }
};

const Settings few_views = {{"count", std::int64_t{10}}, {"size", std::int64_t{64}}};

Findings evaluate(const Scene& scene, const Settings& settings, int threads = 2) {
  return testing::evaluate(overdraw_vulkan_plugin(), scene, settings, threads);
}

const Note* find(const Findings& findings, const std::string& code) {
  for (const Note& note : findings.notes) {
    if (note.code == code) return &note;
  }
  return nullptr;
}

TEST_F(OverdrawVulkanPlugin, measures_overdraw_and_vertices_and_says_who_did) {
  const testing::TestMesh ball = testing::sphere(16, 8);
  const Scene scene =
      testing::scene_of({testing::draw_of(ball, "ball"), testing::draw_of(testing::soup(30, 1), "soup")});
  const Findings findings = evaluate(scene, few_views);
  ASSERT_NE(find(findings, "ratio", 0), nullptr);
  EXPECT_NEAR(find(findings, "ratio", 0)->numerator / *find(findings, "ratio", 0)->denominator, 1, 0.001);
  const OverdrawDevice device;
  ASSERT_NE(find(findings, "device"), nullptr);
  EXPECT_NE(find(findings, "device")->message.find(device.name()), std::string::npos);
  if (const Measured* vertices = find(findings, "vertex-shader-invocations", 1)) {
    EXPECT_EQ(vertices->numerator, 90);
    EXPECT_EQ(vertices->denominator, 30);
    EXPECT_EQ(find(findings, "vertex-shader-invocations", 0)->denominator, ball.indices.size() / 3);
  }
  EXPECT_EQ(find(findings, "gpu-time-light", {}), nullptr);  // not asked for
}

TEST_F(OverdrawVulkanPlugin, takes_times_on_hardware_and_says_why_not_elsewhere) {
  Settings timed = few_views;
  timed["times"] = true;
  const Findings findings = evaluate(testing::scene_of(testing::sphere(16, 8)), timed);
  const OverdrawDevice device;
  if (device.is_processor()) {
    EXPECT_EQ(find(findings, "gpu-time-light", {}), nullptr);
    ASSERT_NE(find(findings, "no-times"), nullptr);
    EXPECT_NE(find(findings, "no-times")->message.find("runs on the processor"), std::string::npos);
  } else {
    ASSERT_NE(find(findings, "gpu-time-heavy", {}), nullptr);
    EXPECT_EQ(find(findings, "gpu-time-heavy", {})->denominator, 10);
    EXPECT_GT(find(findings, "gpu-time-heavy", {})->numerator, 0);
    EXPECT_GT(find(findings, "gpu-time-light", {})->numerator, 0);
  }
}

TEST_F(OverdrawVulkanPlugin, many_subjects_count_the_same_at_any_thread_count) {
  std::vector<Draw> draws;
  for (std::uint64_t i = 0; i < 12; ++i) draws.push_back(testing::draw_of(testing::tangle(i, i % 2 == 0)));
  const Scene scene = testing::scene_of(draws);
  const Findings one = evaluate(scene, few_views, 1);
  const Findings other = evaluate(scene, few_views, 4);
  ASSERT_EQ(other.measured.size(), one.measured.size());
  for (std::size_t i = 0; i < one.measured.size(); ++i) {
    EXPECT_EQ(other.measured[i].metric, one.measured[i].metric);
    EXPECT_EQ(other.measured[i].numerator, one.measured[i].numerator);
    EXPECT_EQ(other.measured[i].denominator, one.measured[i].denominator);
  }
}

TEST_F(OverdrawVulkanPlugin, answers_for_measured_overdraw) {
  const testing::TestMesh mesh = testing::tangle(9, false);
  const Scene scene = testing::scene_of(mesh);
  const auto service = overdraw_vulkan_plugin().overdraw_service({{"faces", std::string("front")}});
  testing::RunFixture fixture;
  OverdrawDevice device;
  const RasterPart part = testing::part_of(mesh);
  const Views views = make_views({.views = "axes", .size = 64});
  EXPECT_EQ(service->count(scene, subjects_of(scene)[0], views, fixture.run),
            overdraw_vulkan(device, {&part, 1}, views));
}

TEST_F(OverdrawVulkanPlugin, a_device_that_is_not_there_is_missed_when_it_is_to_draw) {
  Settings abacus = few_views;
  abacus["device"] = std::string("abacus");
  EXPECT_NO_THROW(overdraw_vulkan_plugin().create(abacus));
  EXPECT_THROW(evaluate(testing::scene_of(testing::grid(1, 1)), abacus), std::runtime_error);
}

}  // namespace
}  // namespace foredraw::overdraw_vulkan_plugin_test
