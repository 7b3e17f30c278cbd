#include "walk_findings_plugin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace foredraw {

namespace {

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double most_of(const std::vector<double>& values) { return values.empty() ? 0 : *std::ranges::max_element(values); }

double deviation_of(const std::vector<double>& values) {
  if (values.empty()) return 0;
  const double mean = sum_of(values) / static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Over the frames in which some choice is within the budget.
double sum_within(const LodWalk& walk, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += walk.is_over[i] ? 0 : values[i];
  return sum;
}

void measure(const LodWalk& walk, const MethodWalk& method, const std::string& group, const Run& run) {
  const auto frames = static_cast<double>(method.milliseconds.size());
  const auto over = std::ranges::count_if(method.milliseconds, [&](double ms) { return ms > walk.budget; });
  run.measure(group + "frame", sum_of(method.milliseconds), frames);
  run.measure(group + "longest-frame", most_of(method.milliseconds), 1);
  run.measure(group + "frame-deviation", deviation_of(method.milliseconds), 1);
  run.measure(group + "over-budget", 100 * static_cast<double>(over), frames);
  run.measure(group + "benefit", 100 * sum_within(walk, method.benefit), std::max(1.0, sum_within(walk, walk.bound)));
  run.measure(group + "switched", 1000 * std::accumulate(method.switched.begin(), method.switched.end(), 0.0),
              std::max(1.0, std::accumulate(walk.seen_again.begin(), walk.seen_again.end(), 0.0)));
  if (!method.errors.empty()) {
    run.measure(group + "picture-error", 100 * sum_of(method.errors), static_cast<double>(method.errors.size()));
    run.measure(group + "picture-floor", 100 * sum_of(walk.floors), static_cast<double>(walk.floors.size()));
  }
  if (!method.samples.empty()) {  // frames were drawn
    double apart = 0;
    for (std::size_t i = 0; i < method.model.size(); ++i) {
      apart += std::abs(method.model[i] - method.milliseconds[i]) / method.milliseconds[i];
    }
    run.measure(group + "selecting", sum_of(method.selecting), frames);
    run.measure(group + "model-error", 100 * apart, frames);
  }
}

/// How well the model would do with constants of this very walk.
void foretell(const LodWalk& walk, const Run& run) {
  const evaluators::lod_walk::WalkFit fit = evaluators::lod_walk::walk_fit(samples_of(walk));
  run.measure("fitted-error", 100 * std::min(fit.max.mean, fit.sum.mean), 1);
  run.note("fit",
           fmt::format("fitted to every second frame, the model predicts the others to {:.1f} % on average, {:.1f} % "
                       "at most, where stages add up; to {:.1f} and {:.1f} % where the slower one counts",
                       100 * fit.sum.mean, 100 * fit.sum.most, 100 * fit.max.mean, 100 * fit.max.most));
}

/// Curves of all methods, and what levels they chose.
void attach(const LodWalk& walk, const Run& run) {
  Chart times{"frame time", "The dashed line is the budget.", "frame", "time of a frame", "ms", {}, {}};
  times.mark = Chart::Mark{"budget", walk.budget};
  Chart benefits{"benefit", "Of the most that any choice within the budget can have.", "frame", "benefit", "%", {}, {}};
  Chart switches{
      "switches", "Objects whose level or rendering differs from the frame before.", "frame", "objects", "", {}, {}};
  for (const MethodWalk& method : walk.methods) {
    const std::string name(to_text(method.method));
    times.lines.push_back({name, method.milliseconds});
    std::vector<double> shares;
    for (std::size_t i = 0; i < walk.bound.size(); ++i) {
      shares.push_back(walk.is_over[i] ? std::nan("") : 100 * method.benefit[i] / walk.bound[i]);
    }
    benefits.lines.push_back({name, std::move(shares)});
    switches.lines.push_back({name, {method.switched.begin(), method.switched.end()}});
    if (method.replay.empty()) continue;
    run.attach(Film{name, "Levels: full detail is white, the coarsest black.", walk.replay_size.width,
                    walk.replay_size.height, method.replay});
  }
  for (Chart* chart : {&times, &benefits, &switches}) run.attach(std::move(*chart));
}

/// The row of the paper's table, and what it does not have.
void tell(const LodWalk& walk, const MethodWalk& method, const Run& run) {
  const auto frames = static_cast<double>(method.milliseconds.size());
  std::string text = fmt::format(
      "{}: frames of {:.2f} ms in the mean, {:.2f} at most, deviation {:.3f}, budget {:.2f}; choosing took {:.2f} ms "
      "in the mean, {:.2f} at most; {:.2f} % of the best benefit",
      to_text(method.method), sum_of(method.milliseconds) / frames, most_of(method.milliseconds),
      deviation_of(method.milliseconds), walk.budget, sum_of(method.selecting) / frames, most_of(method.selecting),
      100 * sum_within(walk, method.benefit) / std::max(1.0, sum_within(walk, walk.bound)));
  if (!method.errors.empty()) {
    text += fmt::format("; picture error {:.2f} % (floor {:.2f})",
                        100 * sum_of(method.errors) / static_cast<double>(method.errors.size()),
                        100 * sum_of(walk.floors) / static_cast<double>(walk.floors.size()));
  }
  run.note("walk", text);
}

/// Figure 10 of the paper: a view with many polygons, and what is drawn of them.
void tell_triangles(const LodWalk& walk, const MethodWalk& method, const Run& run) {
  constexpr double paper_full = 72'570, paper_drawn = 5'300;
  if (walk.triangles.empty()) return;
  const auto most = std::ranges::max_element(walk.triangles);
  const auto frame = static_cast<std::size_t>(most - walk.triangles.begin());
  const auto full = static_cast<double>(*most), drawn = static_cast<double>(method.triangles[frame]);
  run.note(
      "triangles",
      fmt::format("frame {} has the most triangles, {:.0f} in full detail; {} draws {:.0f}, {:.1f} % (figure 10 of "
                  "the paper: {:.0f}, of which {:.0f} are drawn, {:.1f} %)",
                  frame + 1, full, to_text(method.method), drawn, 100 * drawn / std::max(1.0, full), paper_full,
                  paper_drawn, 100 * paper_drawn / paper_full));
}

}  // namespace

void report_walk(const LodWalk& walk, const Run& run) {
  for (const MethodWalk& method : walk.methods) {
    measure(walk, method, std::string(to_text(method.method)) + '.', run);
    if (&method == &walk.methods.back()) measure(walk, method, "", run);
    tell(walk, method, run);
  }
  tell_triangles(walk, walk.methods.back(), run);
  if (const auto over = std::ranges::count(walk.is_over, true); over > 0) {
    run.note("over-budget", fmt::format("in {} of {} frames even the cheapest ways cost more than the budget", over,
                                        walk.is_over.size()));
  }
  if (!samples_of(walk).empty()) foretell(walk, run);
  attach(walk, run);
}

std::vector<FrameSample> samples_of(const LodWalk& walk) {
  std::vector<FrameSample> samples;
  for (const MethodWalk& method : walk.methods) {
    samples.insert(samples.end(), method.samples.begin(), method.samples.end());
  }
  return samples;
}

}  // namespace foredraw
