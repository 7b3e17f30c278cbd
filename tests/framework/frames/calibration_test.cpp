#include <foredraw/frames/calibration.h>

#include "support/rendering_costs.h"

#include <foredraw/base/random.h>
#include <foredraw/frames/reference_machine.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace foredraw::calibration_test {
namespace {

RenderingCosts made_up(Stages stages) {
  RenderingCosts costs;
  costs.stages = stages;
  costs.of(Rendering::full) = {0.9, 0.5, 1.2};
  costs.of(Rendering::without_normal_map) = {0.9, 0.4, 0.7};
  costs.of(Rendering::unlit) = {0.8, 0.3, 0.1};
  costs.frame = 30'000;
  costs.draw = 2'000;
  costs.posed = 3;
  return costs;
}

ObjectWork work_of(const CalibrationFrame& frame) {
  const double objects = frame.objects, squares = frame.squares, pixels = frame.pixels;
  const double triangles = 2 * squares * squares;
  const double vertices = frame.shares_vertices ? (squares + 1) * (squares + 1) : 3 * triangles;
  return {frame.rendering,
          objects * triangles,
          objects * vertices,
          objects * pixels * pixels,
          objects,
          frame.is_posed ? objects * vertices : 0};
}

/// A machine that takes what costs say; in every fourth round ten times as long, and in another one a tenth.
MeasuredMachine machine_of(const RenderingCosts& costs, double noise = 0) {
  return [costs, noise, random = Random(3), count = std::size_t{0}](const CalibrationFrame& frame) mutable {
    FrameSample sample;
    if (frame.objects > 0) sample.drawn.push_back(work_of(frame));
    const std::size_t round = count++ / calibration_frames().size() % 4;
    const double disturbed = round == 0 ? 10 : round == 3 ? 0.1 : 1;
    sample.nanoseconds = frame_cost(costs, sample.drawn) * (1 + noise * (2 * random.unit() - 1)) * disturbed;
    return sample;
  };
}

TEST(Calibration, FindsTheCostsOfAMadeUpMachineAndItsForm) {
  for (const Stages stages : {Stages::max, Stages::sum}) {
    const Calibration found = calibrate(machine_of(made_up(stages)));
    EXPECT_EQ(found.costs.stages, stages);
    EXPECT_LT(testing::apart(found.costs, made_up(stages)), 1e-3) << to_text(stages);
    EXPECT_EQ(found.frames, calibration_frames().size());
    const FitError& right = stages == Stages::max ? found.max_error : found.sum_error;
    const FitError& wrong = stages == Stages::max ? found.sum_error : found.max_error;
    EXPECT_LT(right.most, 1e-5);
    EXPECT_GT(wrong.most, 0.2);
    EXPECT_EQ(right.samples, found.frames - found.frames / 2) << "the half that it was not fitted to";
  }
}

TEST(Calibration, NoiseOfThreePerCentIsHalvedByTheMedian) {
  const Calibration found = calibrate(machine_of(made_up(Stages::max), 0.03));
  EXPECT_EQ(found.costs.stages, Stages::max);
  EXPECT_LT(found.max_error.mean, 0.015);
  EXPECT_LT(testing::apart(found.costs, made_up(Stages::max)), 0.1);
}

TEST(Calibration, FramesFitIntoThePictureAndTellEverythingApart) {
  std::set<std::uint32_t> objects, squares, pixels;
  for (const CalibrationFrame& frame : calibration_frames()) {
    const std::uint32_t in_a_row = calibration_picture / frame.pixels;
    EXPECT_LE(frame.objects, in_a_row * in_a_row);
    objects.insert(frame.objects), squares.insert(frame.squares), pixels.insert(frame.pixels);
  }
  EXPECT_GE(objects.size(), 4u);
  EXPECT_GE(squares.size(), 4u);
  EXPECT_GE(pixels.size(), 4u);
  EXPECT_TRUE(objects.contains(0));
}

TEST(Calibration, EndsWhenItIsCancelledAndTellsHowFarItIs) {
  std::atomic<bool> cancel = false;
  double part = 0;
  int frames = 0;
  CalibrationOptions options;
  options.cancel = &cancel;
  options.progress = [&](double done) {
    EXPECT_GT(done, part);
    part = done;
    cancel = ++frames == 10;
  };
  EXPECT_EQ(calibrate(machine_of(made_up(Stages::max)), options).frames, 0u);
  EXPECT_EQ(frames, 10);
  cancel = false;
  options.cancel = nullptr;
  part = 0;
  calibrate(machine_of(made_up(Stages::max)), options);
  EXPECT_EQ(part, 1);
}

/// That it does what it is asked for: times are the machine's own affair.
TEST(Calibration, TheReferenceRendererDrawsWhatAFrameSays) {
  const MeasuredMachine machine = reference_machine();
  for (const CalibrationFrame& frame :
       {CalibrationFrame{Rendering::full, 4, 12, true, 100}, CalibrationFrame{Rendering::unlit, 16, 1, false, 32},
        CalibrationFrame{Rendering::without_normal_map, 1, 64, true, 250},
        CalibrationFrame{Rendering::full, 4, 12, true, 100, true}}) {
    const FrameSample sample = machine(frame);
    EXPECT_GT(sample.nanoseconds, 0);
    ASSERT_EQ(sample.drawn.size(), 1u);
    EXPECT_EQ(sample.drawn[0], work_of(frame));
  }
  EXPECT_TRUE(machine({}).drawn.empty());
}

}  // namespace
}  // namespace foredraw::calibration_test
