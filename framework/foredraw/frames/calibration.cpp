#include <foredraw/frames/calibration.h>

#include <foredraw/base/random.h>

#include <algorithm>
#include <utility>

namespace foredraw {

namespace {

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(middle));
  return values[middle];
}

/// Both halves have some of everything.
std::pair<std::vector<FrameSample>, std::vector<FrameSample>> halves(std::vector<FrameSample> samples) {
  Random random(1);
  for (std::size_t i = samples.size(); i > 1; --i) std::swap(samples[i - 1], samples[random.below(i)]);
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  return {{samples.begin(), middle}, {middle, samples.end()}};
}

}  // namespace

std::vector<CalibrationFrame> calibration_frames() {
  std::vector<CalibrationFrame> frames{{}};
  for (const Rendering rendering : all_renderings) {
    for (const std::uint32_t squares : {1u, 4u, 12u, 32u, 64u}) {
      for (const bool shares_vertices : {true, false}) {
        for (const std::uint32_t pixels : {8u, 32u, 100u, 250u}) {
          for (const std::uint32_t objects : {1u, 4u, 16u, 64u}) {
            const std::uint32_t in_a_row = calibration_picture / pixels;
            const bool is_too_much = objects * squares * squares > 20'000;  // a frame of some milliseconds at most
            if (objects > in_a_row * in_a_row || is_too_much) continue;
            frames.push_back({rendering, objects, squares, shares_vertices, pixels});
            // What joints take is the same by each rendering.
            if (rendering == Rendering::full && shares_vertices) {
              frames.push_back({rendering, objects, squares, shares_vertices, pixels, true});
            }
          }
        }
      }
    }
  }
  return frames;
}

Calibration calibrate(const MeasuredMachine& machine, const CalibrationOptions& options) {
  const std::vector<CalibrationFrame> frames = calibration_frames();
  const int rounds = std::max(1, options.rounds);
  std::vector<FrameSample> samples(frames.size());
  std::vector<std::vector<double>> times(frames.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed)) return {};
      samples[i] = machine(frames[i]);
      times[i].push_back(samples[i].nanoseconds);
      const double done = static_cast<double>(static_cast<std::size_t>(round) * frames.size() + i + 1);
      if (options.progress)
        options.progress(done / static_cast<double>(static_cast<std::size_t>(rounds) * frames.size()));
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].nanoseconds = median(std::move(times[i]));
  const auto [first, second] = halves(samples);
  Calibration made;
  made.frames = samples.size();
  made.max_error = fit_error(fit_costs(first, Stages::max), second);
  made.sum_error = fit_error(fit_costs(first, Stages::sum), second);
  made.costs = fit_costs(samples, made.sum_error.mean < made.max_error.mean ? Stages::sum : Stages::max);
  return made;
}

}  // namespace foredraw
