#include "frame_timers_plugin.h"
#include "lod_walk.h"

#include <foredraw/technique/frame_options.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

using walking::Accuracy;
using walking::Method;

enum class FrameTimes { model, drawn, vulkan };

struct WalkSettings : LodWalkOptions, FrameSet {
  std::string methods_text = "none static feedback value incremental budget";
  std::string costs_file;
  FrameTimes times = FrameTimes::model;
};

std::vector<Method> methods_in(const std::string& text) {
  std::vector<Method> methods;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const auto found = std::ranges::find(walking::all_methods, word, [](Method m) { return to_text(m); });
    if (found == walking::all_methods.end()) {
      throw std::invalid_argument(
          fmt::format("there is no method '{}'; expected none, static, feedback, value, "
                      "incremental or budget, separated by spaces",
                      word));
    }
    if (std::ranges::find(methods, *found) == methods.end()) methods.push_back(*found);
  }
  if (methods.empty()) throw std::invalid_argument("methods is empty, but one at least must walk");
  return methods;
}

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

class LodWalkEvaluator final : public Evaluator {
 public:
  explicit LodWalkEvaluator(WalkSettings settings) : settings_(std::move(settings)) {
    if (const auto mistake = mistake_in(static_cast<const FrameSet&>(settings_))) throw std::invalid_argument(*mistake);
    settings_.methods = methods_in(settings_.methods_text);
    if (settings_.times == FrameTimes::vulkan && !has_vulkan_timer()) {
      throw std::invalid_argument(
          "times = vulkan: this program was built without Vulkan or glslangValidator; expected drawn or model");
    }
    ReferenceRenderer(settings_.size(), settings_.samples);  // says what is wrong with their numbers before the walk
    if (settings_.costs_file.empty()) return;
    auto costs = read_costs(settings_.costs_file);
    if (const auto* why = std::get_if<std::string>(&costs)) throw std::invalid_argument(*why);
    settings_.costs = std::get<RenderingCosts>(costs);
  }

  void evaluate(const Scene& scene, Run& run) const override {
    const FrameScene frames(scene, run.analyses, run.executor);
    if (frames.objects().empty()) return run.note("nothing-to-see", "no node shows triangles");
    auto path = camera_path(frames, settings_);
    if (const auto* why = std::get_if<std::string>(&path)) throw std::runtime_error(*why);
    LodWalkOptions options = settings_;
    options.seed = run.seed;
    options.timer = timer(frames, run);
    if (settings_.costs_file.empty() && !options.timer) {
      run.note("example-costs", "costs are an example's, not those of a machine; name a file of them: costs = FILE");
    } else if (settings_.costs_file.empty()) {
      options.costs = fitted_costs(frames, std::get<CameraPath>(path), options, run);
    }
    const auto walk =
        lod_walk(frames, std::get<CameraPath>(path), settings_.size(), options, run.executor, run.cancel, run.progress);
    if (!walk) throw std::runtime_error("cancelled");
    for (const MethodWalk& method : walk->methods) {
      measure(*walk, method, std::string(to_text(method.method)) + '.', run);
      if (&method == &walk->methods.back()) measure(*walk, method, "", run);
      tell(*walk, method, run);
    }
    if (const std::size_t over = std::ranges::count(walk->is_over, true); over > 0) {
      run.note("over-budget", fmt::format("in {} of {} frames even the cheapest ways cost more than the budget", over,
                                          walk->is_over.size()));
    }
    if (options.timer) foretell(*walk, run);
    attach(*walk, run);
  }

 private:
  /// Costs of who draws the frames, from every fourth frame of the path, drawn finely, coarsely and in between.
  RenderingCosts fitted_costs(const FrameScene& frames, const CameraPath& path, LodWalkOptions options,
                              Run& run) const {
    CameraPath some;
    for (std::size_t i = 0; i < path.size(); i += 4) some.push_back(path[i]);
    options.methods = {Method::none, Method::by_size, Method::budget};
    options.pictures = 0;
    options.replay = false;
    const auto walk = lod_walk(frames, some, settings_.size(), options, run.executor, run.cancel);
    if (!walk) throw std::runtime_error("cancelled");
    const std::vector<FrameSample> samples = samples_of(*walk);
    const walking::WalkFit fit = walking::walk_fit(samples);
    const Stages stages = fit.max.mean < fit.sum.mean ? Stages::max : Stages::sum;
    run.note("fitted-costs",
             fmt::format("costs were fitted to {} frames before the walk ({}); to use others, name a "
                         "file of them: costs = FILE",
                         samples.size(), stages == Stages::max ? "the slower stage counts" : "stages add up"));
    return fit_costs(samples, stages);
  }

  static std::vector<FrameSample> samples_of(const LodWalk& walk) {
    std::vector<FrameSample> samples;
    for (const MethodWalk& method : walk.methods) {
      samples.insert(samples.end(), method.samples.begin(), method.samples.end());
    }
    return samples;
  }

  /// None: times are the model's.
  FrameTimer timer(const FrameScene& frames, Run& run) const {
    switch (settings_.times) {
      case FrameTimes::model: break;
      case FrameTimes::drawn: return reference_timer(frames, settings_.size());
      case FrameTimes::vulkan: {
        NamedTimer made = vulkan_timer(frames, settings_.size());
        run.note("device", "frames were drawn by " + made.name);
        return std::move(made.timer);
      }
    }
    return {};
  }

  void measure(const LodWalk& walk, const MethodWalk& method, const std::string& group, Run& run) const {
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
    if (settings_.times != FrameTimes::model) {
      double apart = 0;
      for (std::size_t i = 0; i < method.model.size(); ++i) {
        apart += std::abs(method.model[i] - method.milliseconds[i]) / method.milliseconds[i];
      }
      run.measure(group + "selecting", sum_of(method.selecting), frames);
      run.measure(group + "model-error", 100 * apart, frames);
    }
  }

  /// How well the model would do with constants of this very walk.
  static void foretell(const LodWalk& walk, Run& run) {
    const walking::WalkFit fit = walking::walk_fit(samples_of(walk));
    run.measure("fitted-error", 100 * std::min(fit.max.mean, fit.sum.mean), 1);
    run.note("fit",
             fmt::format("fitted to every second frame, the model foretells the others to {:.1f} % in the mean, "
                         "{:.1f} % at most, where stages add up; to {:.1f} and {:.1f} % where the slower one counts",
                         100 * fit.sum.mean, 100 * fit.sum.most, 100 * fit.max.mean, 100 * fit.max.most));
  }

  /// Curves of all methods, and what levels they chose.
  static void attach(const LodWalk& walk, Run& run) {
    Chart times{"frame time", "The dashed line is the budget.", "frame", "time of a frame", "ms", {}, {}};
    times.mark = Chart::Mark{"budget", walk.budget};
    Chart benefits{"benefit", "Of the most that any choice within the budget can have.", "frame", "benefit", "%", {},
                   {}};
    Chart switches{"switches", "Objects that are drawn otherwise than in the frame before.", "frame", "objects", "", {},
                   {}};
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
  static void tell(const LodWalk& walk, const MethodWalk& method, Run& run) {
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

  WalkSettings settings_;
};

}  // namespace

Plugin lod_walk_plugin() {
  OptionTable<WalkSettings> table;
  add_frame_rows(table);
  table.row(&WalkSettings::methods_text, "methods",
            "Which methods walk: none, static, feedback, value, incremental and budget, separated by spaces; the "
            "scene's own figures are those of the last one");
  table.number_or_text(
      &WalkSettings::costs_file, "costs",
      "File with what a triangle, a vertex and a pixel cost on the machine (default: an example's; where frames are "
      "drawn, fitted to some of them before the walk)",
      OptionType::views);
  table.row(&WalkSettings::budget, "budget", "Time of a frame (default: a share of what full detail costs)",
            {0.0001, 1e6, "ms"});
  table.row(&WalkSettings::share, "share", "Share of what full detail costs in the mean that is the budget",
            {0.001, 10, ""});
  table.choice(
      &WalkSettings::times, "times",
      "What frames take: what the model says, with noise; or what drawing them takes, on the processor or on a "
      "Vulkan device, which differs from run to run",
      {{"model", FrameTimes::model}, {"drawn", FrameTimes::drawn}, {"vulkan", FrameTimes::vulkan}});
  table.row(&WalkSettings::noise, "noise", "How far a frame's time is off what the model says, at most", {0, 0.9, ""});
  table.row(&WalkSettings::occlusion, "occlusion", "What something hides is neither chosen for nor drawn");
  table.row(&WalkSettings::renderings, "renderings", "Objects may be drawn without normal map, or unlit");
  table.row(&WalkSettings::pixels, "pixels",
            "Largest triangle of static, on the screen (default: as large as the budget asks for)",
            {0.001, 1e6, "pixels"});
  table.choice(&WalkSettings::accuracy, "accuracy",
               "What accuracies are taken from: what pictures of each object lose, the errors of its levels on the "
               "screen, or samples, its numbers of vertices",
               {{"pictures", Accuracy::pictures}, {"errors", Accuracy::errors}, {"samples", Accuracy::samples}});
  table.row(&WalkSettings::focus, "focus", "What an object in a corner is worth, beside one in the middle", {0, 1, ""});
  table.row(&WalkSettings::motion, "motion", "What moves fast over the picture is worth less");
  table.row(&WalkSettings::hysteresis, "hysteresis",
            "What another level or rendering than in the last frame is worth less, for each step", {0, 1, ""});
  table.row(&WalkSettings::pictures, "pictures", "Frames whose pictures are compared with full detail",
            {0, 10000, "frames"});
  table.row(&WalkSettings::samples, "samples", "Samples along each edge of their pixels", {1, 16, "samples"});
  table.row(&WalkSettings::replay, "replay", "The page shows the levels of every frame, as pictures in grey");

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "lod-walk",
      .summary = "Walks a camera through the scene and compares methods that choose levels of detail for a budget",
      .reference = "Funkhouser, Sequin 1993",
      .metrics =
          {
              {"frame", "ms", "Time of a frame, in the mean"},
              {"longest-frame", "ms", "Time of the longest frame", true, true},
              {"frame-deviation", "ms", "Standard deviation of the frames' times"},
              {"over-budget", "%", "Frames that take longer than the budget"},
              {"benefit", "% of the bound",
               "Benefit of what was chosen, of the most that any choice within the budget can have", false},
              {"switched", "of 1000 objects", "Objects that are drawn otherwise than in the frame before"},
              {"selecting", "ms", "Time that the choice takes for a frame, where frames are drawn"},
              {"picture-error", "%", "Root mean square difference from full detail, of a channel's range"},
              {"picture-floor", "%", "The same between two pictures of full detail from samples in different places",
               true, false, true},
              {"model-error", "%", "How far the model's time is off that of the frame, in the mean"},
              {"fitted-error", "%", "The same of a model that was fitted to every second frame, on the others"},
          },
  };
  bind_options(plugin, std::move(table),
               [](const WalkSettings& settings) { return std::make_unique<LodWalkEvaluator>(settings); });
  return plugin;
}

}  // namespace foredraw
