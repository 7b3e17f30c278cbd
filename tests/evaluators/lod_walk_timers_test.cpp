#include "evaluators/lod_walk/lod_walk.h"

#include "support/levelled_field.h"

#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw::lod_walk_timers_test {
namespace {

TEST(LodWalkTimers, FramesTakeWhatTheTimerSays) {
  const Scene scene = testing::levelled_field(6);
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const FrameSet set{.frames = 5, .width = 160, .height = 90};
  const CameraPath path = std::get<CameraPath>(camera_path(frames, set));
  LodWalkOptions options;
  options.methods = {evaluators::lod_walk::Method::none, evaluators::lod_walk::Method::budget};
  options.pictures = 0;
  options.renderings = false;
  options.accuracy = evaluators::lod_walk::Accuracy::errors;
  std::size_t calls = 0, objects = 0;
  options.timer = [&](const FrameMoment&, const FrameCamera&, std::span<const DrawnObject> drawn) {
    objects += drawn.size();
    return 1e6 * static_cast<double>(++calls);
  };
  const LodWalk walk = *lod_walk(frames, path, set.size(), options, executor);
  EXPECT_EQ(calls, 10u);
  EXPECT_GT(objects, 10u);
  EXPECT_EQ(walk.methods[0].milliseconds, (std::vector<double>{1, 3, 5, 7, 9}));
  EXPECT_EQ(walk.methods[1].milliseconds, (std::vector<double>{2, 4, 6, 8, 10}));
}

/// What the plugin finds with times of that kind; or why it does not.
std::variant<Findings, std::string> walked(const std::string& times) {
  const Settings settings = {{"times", times},
                             {"frames", std::int64_t{3}},
                             {"width", std::int64_t{160}},
                             {"height", std::int64_t{90}},
                             {"pictures", std::int64_t{0}},
                             {"accuracy", std::string("errors")},
                             {"renderings", false},
                             {"methods", std::string("none")}};
  testing::RunFixture fixture;
  try {
    const auto made = lod_walk_plugin().create(settings);
    std::get<std::unique_ptr<Evaluator>>(made)->evaluate(testing::levelled_field(4), fixture.run);
  } catch (const std::exception& error) {
    return error.what();
  }
  return fixture.findings;
}

bool has_figure(const Findings& findings, const std::string& name) {
  return std::ranges::any_of(findings.measured, [&](const Measured& m) { return m.metric == name && m.numerator > 0; });
}

TEST(LodWalkTimers, ModelsHaveNoError) {
  EXPECT_FALSE(has_figure(std::get<Findings>(walked("model")), "model-error"));
  EXPECT_TRUE(has_figure(std::get<Findings>(walked("drawn")), "model-error"));
}

TEST(LodWalkTimers, VulkanDrawsOrSaysWhyNot) {
  const auto result = walked("vulkan");
  if (const auto* why = std::get_if<std::string>(&result)) {
    EXPECT_EQ(why->find("times = vulkan: "), 0u) << *why;
    GTEST_SKIP() << *why;
  }
  const Findings& findings = std::get<Findings>(result);
  EXPECT_TRUE(has_figure(findings, "frame"));
  EXPECT_TRUE(has_figure(findings, "model-error"));
  EXPECT_TRUE(std::ranges::any_of(findings.notes, [](const Note& note) {
    return note.code == "device" && note.message.starts_with("frames were drawn by ");
  }));
}

}  // namespace
}  // namespace foredraw::lod_walk_timers_test
