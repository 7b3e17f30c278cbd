#include <foredraw/frames/cost_fit.h>

#include "support/rendering_costs.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::cost_fit_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

RenderingCosts machine(Stages stages) {
  RenderingCosts costs;
  costs.stages = stages;
  costs.of(Rendering::full) = {0.7, 0.4, 1.1};
  costs.of(Rendering::without_normal_map) = {0.7, 0.3, 0.6};
  costs.of(Rendering::unlit) = {0.6, 0.2, 0.15};
  costs.frame = 90'000;
  costs.draw = 1'200;
  return costs;
}

/// Evenly in octaves.
double between(Random& random, int least_octave, int most_octave) {
  const auto octave =
      least_octave + static_cast<int>(random.below(static_cast<std::uint64_t>(most_octave - least_octave)));
  return std::floor(std::ldexp(1 + random.unit(), octave));
}

/// Frames of 1 to 12 objects each, from far to near and from coarse to fine. `noise`: of times, either way at most.
std::vector<FrameSample> frames(std::size_t count, const RenderingCosts& costs, double noise = 0,
                                std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<FrameSample> samples(count);
  for (FrameSample& sample : samples) {
    sample.drawn.resize(1 + random.below(12));
    for (ObjectWork& work : sample.drawn) {
      work.rendering = all_renderings[random.below(3)];
      work.triangles = between(random, 6, 18);
      work.vertices = std::floor(work.triangles * (0.5 + random.unit()));
      work.pixels = between(random, 6, 18);
      work.draws = 1 + static_cast<double>(random.below(3));
      if (costs.posed > 0 && random.below(3) == 0) work.posed = work.vertices;
    }
    const double off = noise * (2 * random.unit() - 1);
    sample.nanoseconds = frame_cost(costs, sample.drawn) * (1 + off);
  }
  return samples;
}

TEST(CostFit, FindsWhatJointsTake) {
  for (const Stages stages : {Stages::sum, Stages::max}) {
    RenderingCosts costs = machine(stages);
    costs.posed = 2.5;
    const RenderingCosts found = fit_costs(frames(300, costs), stages);
    EXPECT_LT(testing::apart(found, costs), 1e-3) << to_text(stages);
    EXPECT_EQ(fit_costs(frames(300, machine(stages)), stages).posed, 0);
  }
}

TEST(CostFit, FindsTheConstantsOfBothFormsExactly) {
  for (const Stages stages : {Stages::sum, Stages::max}) {
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      const auto samples = frames(300, machine(stages), 0, seed);
      const RenderingCosts found = fit_costs(samples, stages);
      EXPECT_EQ(found.stages, stages);
      EXPECT_LT(testing::apart(found, machine(stages)), 1e-4) << to_text(stages) << ' ' << seed;  // costs are floats
      EXPECT_LT(fit_error(found, samples).most, 1e-6) << to_text(stages) << ' ' << seed;
    }
  }
}

/// Times that are 3 % off either way leave single constants 10 % off, which make up for one another: other frames are
/// foretold to a half per cent.
TEST(CostFit, ThreePerCentOfNoiseLeaveTheForecastNearlyRight) {
  for (const Stages stages : {Stages::sum, Stages::max}) {
    const RenderingCosts found = fit_costs(frames(1000, machine(stages), 0.03, 2), stages);
    EXPECT_LT(testing::apart(found, machine(stages)), 0.1) << to_text(stages);
    const FitError error = fit_error(found, frames(500, machine(stages), 0, 3));
    EXPECT_LT(error.mean, 0.005) << to_text(stages);
    EXPECT_LT(error.most, 0.02) << to_text(stages);
  }
}

/// Half of the frames foretell the other half. Where pixels hide triangles, a sum cannot be right: what triangles cost
/// hangs on how large they are shown.
TEST(CostFit, OfAMachineWhoseStagesWorkAtOnceOnlyTheMaximumForetells) {
  const auto samples = frames(600, machine(Stages::max), 0.03, 4);
  const auto first = std::span(samples).first(300), second = std::span(samples).subspan(300);
  const FitError by_max = fit_error(fit_costs(first, Stages::max), second);
  const FitError by_sum = fit_error(fit_costs(first, Stages::sum), second);
  EXPECT_LT(by_max.mean, 0.02);
  EXPECT_LT(by_max.most, 0.06);
  EXPECT_GT(by_sum.mean, 0.05);
  EXPECT_GT(by_sum.most, 0.3);
}

TEST(CostFit, OfAMachineThatDoesOneAfterTheOtherOnlyTheSumForetells) {
  const auto samples = frames(600, machine(Stages::sum), 0.03, 4);
  const auto first = std::span(samples).first(300), second = std::span(samples).subspan(300);
  EXPECT_LT(fit_error(fit_costs(first, Stages::sum), second).mean, 0.02);
  EXPECT_GT(fit_error(fit_costs(first, Stages::max), second).mean, 0.05);
}

TEST(CostFit, OfNoSampleIsZero) {
  for (const Stages stages : {Stages::sum, Stages::max}) {
    RenderingCosts zero;
    zero.stages = stages;
    EXPECT_EQ(fit_costs({}, stages), zero);
    const FitError error = fit_error(zero, {});
    EXPECT_EQ(error.samples, 0u);
    EXPECT_EQ(error.mean, 0);
  }
}

TEST(CostFit, ForetellsItsOneSampleAndSamplesThatAreAllTheSame) {
  const FrameSample one{{{Rendering::full, 1000, 600, 5000}}, 70'000};
  for (const Stages stages : {Stages::sum, Stages::max}) {
    for (const std::vector<FrameSample>& samples : {std::vector{one}, std::vector(50, one)}) {
      const RenderingCosts found = fit_costs(samples, stages);
      EXPECT_LT(fit_error(found, samples).most, 1e-6);
      EXPECT_NEAR(found.frame, 70'000, 1e-6) << "what could be anything is the frame's";
      EXPECT_NEAR(found.of(Rendering::full).pixel, 0, 1e-12);
    }
  }
}

TEST(CostFit, WhatIsAlwaysZeroCostsNothing) {
  std::vector<FrameSample> samples;
  for (int i = 0; i < 20; ++i) samples.push_back({{{Rendering::unlit, 0, 0, 100.0 * i, 0}}, 30 + 50.0 * i});
  samples.push_back({{}, 30});
  for (const Stages stages : {Stages::sum, Stages::max}) {
    const RenderingCosts found = fit_costs(samples, stages);
    EXPECT_NEAR(found.of(Rendering::unlit).pixel, 0.5, 1e-6);
    EXPECT_EQ(found.of(Rendering::unlit).triangle, 0);
    EXPECT_EQ(found.draw, 0);
    EXPECT_NEAR(found.frame, 30, 1e-4);
  }
}

TEST(CostFit, LeavesOutWhatIsNoMeasurement) {
  for (const Stages stages : {Stages::sum, Stages::max}) {
    std::vector<FrameSample> samples = frames(200, machine(stages));
    const RenderingCosts found = fit_costs(samples, stages);
    const ObjectWork some{Rendering::full, 10, 10, 10};
    for (const double time : {none, 0.0, -5.0, std::numeric_limits<double>::infinity()}) {
      samples.push_back({{some}, time});
    }
    for (const double amount : {none, -1.0, std::numeric_limits<double>::infinity(), 1e300}) {
      samples.push_back({{some, {Rendering::full, amount, 10, 10}}, 1000});
      samples.push_back({{{Rendering::full, 10, amount, 10}}, 1000});
      samples.push_back({{{Rendering::full, 10, 10, amount}}, 1000});
      samples.push_back({{{Rendering::full, 10, 10, 10, amount}}, 1000});
    }
    EXPECT_EQ(fit_costs(samples, stages), found);
    EXPECT_EQ(fit_error(found, samples).samples, 200u);
  }
}

/// A rendering for nothing would be chosen everywhere.
TEST(CostFit, ARenderingThatWasNeverDrawnCostsWhatTheOneBeforeItDoes) {
  std::vector<FrameSample> samples = frames(300, machine(Stages::max));
  for (FrameSample& sample : samples) {
    for (ObjectWork& work : sample.drawn) work.rendering = Rendering::without_normal_map;
    sample.nanoseconds = frame_cost(machine(Stages::max), sample.drawn);
  }
  const RenderingCosts found = fit_costs(samples, Stages::max);
  EXPECT_NEAR(found.of(Rendering::without_normal_map).pixel, 0.6, 1e-4);
  EXPECT_EQ(found.of(Rendering::unlit), found.of(Rendering::without_normal_map));
  EXPECT_EQ(found.of(Rendering::full), found.of(Rendering::without_normal_map));
}

TEST(CostFit, AnswersAlikeAtEveryCallAndHardlyHangsOnTheSequence) {
  std::vector<FrameSample> samples = frames(200, machine(Stages::max), 0.03);
  const RenderingCosts found = fit_costs(samples, Stages::max);
  EXPECT_EQ(fit_costs(samples, Stages::max), found);
  std::ranges::reverse(samples);
  EXPECT_LT(testing::apart(fit_costs(samples, Stages::max), found), 1e-6);
}

}  // namespace
}  // namespace foredraw::cost_fit_test
