#include "evaluators/lod_walk/lod_walk.h"

#include "support/displaced.h"
#include "support/levelled_field.h"

#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::lod_walk_test {
namespace {

using evaluators::lod_walk::Method;

struct Walked {
  Scene scene = testing::levelled_field(12);
  Analyses analyses;
  Executor executor{2};
  FrameScene frames{scene, analyses, executor};
  FrameSet set{.frames = 40, .width = 160, .height = 90};
  CameraPath path = std::get<CameraPath>(camera_path(frames, set));

  LodWalk walk(const LodWalkOptions& options) const { return *lod_walk(frames, path, set.size(), options, executor); }
};

/// Of a machine whose draw calls are free: objects are few here.
LodWalkOptions usual() {
  LodWalkOptions options;
  options.costs = {};
  options.costs.renderings = {RenderingCost{1.5, 1, 0.9}, RenderingCost{1.5, 1, 0.6}, RenderingCost{1.5, 1, 0.2}};
  return options;
}

LodWalkOptions without_pictures() {
  LodWalkOptions options = usual();
  options.pictures = 0;
  options.renderings = false;
  options.accuracy = evaluators::lod_walk::Accuracy::errors;
  return options;
}

const MethodWalk& of(const LodWalk& walk, Method method) {
  return *std::ranges::find(walk.methods, method, &MethodWalk::method);
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }
double most(const std::vector<double>& values) { return *std::ranges::max_element(values); }

TEST(LodWalk, OursNeverExceedsTheBudgetByTheModel) {
  const LodWalk walk = Walked().walk(without_pictures());
  EXPECT_LE(most(of(walk, Method::budget).model), walk.budget);
  EXPECT_LE(most(of(walk, Method::budget).milliseconds), walk.budget * 1.03);
  EXPECT_GT(most(of(walk, Method::none).model), 2 * walk.budget);
  EXPECT_GT(most(of(walk, Method::fed_back).milliseconds), walk.budget * 1.03);
}

TEST(LodWalk, OursReachesTheBound) {
  LodWalkOptions options = without_pictures();
  options.hysteresis = 0;
  options.focus = 0.5;
  options.motion = true;
  const LodWalk walk = Walked().walk(options);
  for (std::size_t frame = 0; frame < walk.bound.size(); ++frame) {
    EXPECT_LE(of(walk, Method::budget).benefit[frame], walk.bound[frame]);
  }
  EXPECT_GT(sum(of(walk, Method::budget).benefit), 0.997 * sum(walk.bound));
  EXPECT_LT(sum(of(walk, Method::by_size).benefit), sum(of(walk, Method::budget).benefit));
}

TEST(LodWalk, StaticCostsWhatTheBudgetAllows) {
  const LodWalk walk = Walked().walk(without_pictures());
  const std::vector<double>& full = of(walk, Method::none).model;
  double allowed = 0;
  for (const double cost : full) allowed += std::min(cost, walk.budget);
  EXPECT_LE(sum(of(walk, Method::by_size).model), allowed);
  EXPECT_GT(sum(of(walk, Method::by_size).model), 0.6 * allowed);
}

TEST(LodWalk, HysteresisSavesSwitches) {
  const Walked walked;
  LodWalkOptions options = without_pictures();
  options.methods = {Method::budget};
  options.hysteresis = 0;
  const LodWalk without = walked.walk(options);
  options.hysteresis = 0.4;
  const LodWalk with = walked.walk(options);
  const auto switches = [](const LodWalk& walk) {
    const auto& switched = walk.methods.front().switched;
    return std::accumulate(switched.begin(), switched.end(), 0u);
  };
  EXPECT_LT(switches(with), switches(without));
  EXPECT_GT(sum(with.methods.front().benefit), 0.98 * sum(without.methods.front().benefit));
}

TEST(LodWalk, FullDetailHasNoErrorAndOursLessThanStatic) {
  LodWalkOptions options = usual();
  options.methods = {Method::none, Method::by_size, Method::budget};
  options.pictures = 20;
  options.samples = 2;
  options.share = 0.2;
  const LodWalk walk = Walked().walk(options);
  ASSERT_EQ(walk.floors.size(), 20u);
  EXPECT_EQ(of(walk, Method::none).errors, std::vector<double>(20, 0));
  EXPECT_GT(sum(of(walk, Method::by_size).errors), 0);
  EXPECT_LT(sum(of(walk, Method::budget).errors), sum(of(walk, Method::by_size).errors));
}

TEST(LodWalk, IsTheSameAtAnyNumberOfThreads) {
  const Walked walked;
  LodWalkOptions options = usual();
  options.pictures = 2;
  options.replay = true;
  const LodWalk a = *lod_walk(walked.frames, walked.path, walked.set.size(), options, Executor(1));
  const LodWalk b = *lod_walk(walked.frames, walked.path, walked.set.size(), options, Executor(4));
  EXPECT_EQ(a.budget, b.budget);
  EXPECT_EQ(a.bound, b.bound);
  for (std::size_t m = 0; m < a.methods.size(); ++m) {
    EXPECT_EQ(a.methods[m].milliseconds, b.methods[m].milliseconds);
    EXPECT_EQ(a.methods[m].benefit, b.methods[m].benefit);
    EXPECT_EQ(a.methods[m].errors, b.methods[m].errors);
    ASSERT_EQ(a.methods[m].replay.size(), 40u);
    EXPECT_EQ(a.methods[m].replay, b.methods[m].replay);
  }
}

TEST(LodWalk, EndsWhenItIsCancelled) {
  const Walked walked;
  const std::atomic<bool> cancel = true;
  EXPECT_FALSE(lod_walk(walked.frames, walked.path, walked.set.size(), {}, walked.executor, &cancel));
}

/// What the plugin says of wrong words.
std::string mistake(const Settings& settings) {
  try {
    lod_walk_plugin().create(settings);
  } catch (const std::exception& e) {
    return e.what();
  }
  return {};
}

TEST(LodWalk, SaysHowDisplacedDrawsAreShown) {
  const auto map =
      testing::height_image(16, 16, [](auto x, auto y) { return static_cast<std::uint16_t>(999 * (x + y)); });
  const Scene scene = testing::displaced_grid(2, 2, map);
  testing::RunFixture fixture;
  const Technique walk = lod_walk_plugin().create({{"frames", std::int64_t{2}},
                                                   {"width", std::int64_t{32}},
                                                   {"height", std::int64_t{32}},
                                                   {"pictures", std::int64_t{1}}});
  std::get<std::unique_ptr<Evaluator>>(walk)->evaluate(scene, fixture.run);
  const auto note = std::ranges::find(fixture.findings.notes, "displaced", &Note::code);
  ASSERT_NE(note, fixture.findings.notes.end());
  EXPECT_NE(note->message.find("1 displaced draw is shown divided"), std::string::npos) << note->message;
  EXPECT_NE(note->message.find("tessellate(levels=4)"), std::string::npos) << note->message;
}

TEST(LodWalk, WrongWordsAreTold) {
  EXPECT_NE(mistake({{"methods", std::string("none magic")}}).find("'magic'"), std::string::npos);
  EXPECT_NE(mistake({{"methods", std::string("")}}).find("empty"), std::string::npos);
  EXPECT_NE(mistake({{"path", std::string("arround")}}).find("did you mean 'around'?"), std::string::npos);
  EXPECT_NE(mistake({{"width", std::int64_t{4096}}, {"samples", std::int64_t{8}}}).find("4096 x 360"),
            std::string::npos);
  EXPECT_NE(mistake({{"path", std::string("/nowhere/a.walk")}}).find("/nowhere/a.walk"), std::string::npos);
  EXPECT_NE(mistake({{"costs", std::string("/nowhere/machine.costs")}}).find("/nowhere/machine.costs"),
            std::string::npos);
}

}  // namespace
}  // namespace foredraw::lod_walk_test
