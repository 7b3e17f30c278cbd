#include "frame_timers_plugin.h"
#include "lod_walk.h"
#include "walk_findings_plugin.h"

#include <foredraw/measuring/frame_options.h>
#include <foredraw/scene/levels.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

using evaluators::lod_walk::Accuracy;
using evaluators::lod_walk::Method;

enum class FrameTimes { model, drawn, vulkan };

struct WalkSettings : LodWalkOptions, FrameSet {
  std::string methods_text = "none static feedback budget";
  std::string costs_file;
  FrameTimes times = FrameTimes::model;
};

std::vector<Method> methods_in(const std::string& text) {
  std::vector<Method> methods;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const auto found = std::ranges::find(evaluators::lod_walk::all_methods, word, [](Method m) { return to_text(m); });
    if (found == evaluators::lod_walk::all_methods.end()) {
      throw std::invalid_argument(
          fmt::format("there is no method '{}'; expected none, static, feedback or budget, separated by spaces", word));
    }
    if (std::ranges::find(methods, *found) == methods.end()) methods.push_back(*found);
  }
  if (methods.empty())
    throw std::invalid_argument("methods is empty; name at least one of none, static, feedback and budget");
  return methods;
}

class LodWalkEvaluator final : public Evaluator {
 public:
  explicit LodWalkEvaluator(WalkSettings settings) : settings_(std::move(settings)) {
    if (const auto mistake = mistake_in(static_cast<const FrameSet&>(settings_))) throw std::invalid_argument(*mistake);
    if (is_camera_file(settings_.path)) {  // read now, so that the plan tells what is wrong with it
      const auto keys = read_camera_keys(settings_.path);
      if (const auto* why = std::get_if<std::string>(&keys)) throw std::invalid_argument(*why);
    }
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
    tell_displaced(scene, frames, run);
    auto path = camera_path(frames, settings_);
    if (const auto* why = std::get_if<std::string>(&path)) throw std::runtime_error(*why);
    LodWalkOptions options = settings_;
    options.seed = run.seed;
    options.timer = timer(frames, run);
    if (settings_.costs_file.empty() && !options.timer) {
      run.note("example-costs",
               "costs are those of an example, not of a machine; measure yours with `foredraw calibrate -o FILE` and "
               "name the file: costs = FILE");
    } else if (settings_.costs_file.empty()) {
      options.costs = fitted_costs(frames, std::get<CameraPath>(path), options, run);
    }
    const auto walk =
        lod_walk(frames, std::get<CameraPath>(path), settings_.size(), options, run.executor, run.cancel, run.progress);
    if (!walk) throw std::runtime_error("cancelled");
    report_walk(*walk, run);
  }

 private:
  /// What full detail is of draws that a map displaces, and what it is not.
  static void tell_displaced(const Scene& scene, const FrameScene& frames, const Run& run) {
    std::size_t displaced = 0, triangles = 0, coarser = 0;
    for (std::size_t d = 0; d < scene.draws.size(); ++d) {
      const Level &stored = scene.draws[d].full(), &shown = frames.scene().draws[d].full();
      if (shown.vertices == stored.vertices) continue;
      ++displaced;
      triangles += shown.stream().triangle_count();
      coarser += scene.draws[d].levels.size() > 1 ? 1 : 0;
    }
    if (displaced == 0) return;
    std::string note = fmt::format("{} displaced {} shown divided and moved by the heights, in {} triangles", displaced,
                                   displaced == 1 ? "draw is" : "draws are", triangles);
    if (coarser > 0) note += "; coarser levels are shown as they are stored, without heights";
    if (coarser < displaced) note += "; for levels of what is displaced put `tessellate(levels=4)` before lod-walk";
    run.note("displaced", note);
  }

  /// Costs of who draws the frames, from every fourth frame of the path: drawn finely, coarsely and in between; then as
  /// the costs so far would have it, until these foretell what was drawn so to a tenth. For where a choice is made by
  /// costs, they have to be right.
  RenderingCosts fitted_costs(const FrameScene& frames, const CameraPath& path, LodWalkOptions options,
                              Run& run) const {
    constexpr int most_rounds = 8;
    constexpr double good = 0.1;
    CameraPath some;
    for (std::size_t i = 0; i < path.size(); i += 4) some.push_back(path[i]);
    options.methods = {Method::none, Method::by_size, Method::budget};
    options.pictures = 0;
    options.replay = false;
    std::vector<FrameSample> samples;
    for (int round = 0; round < most_rounds; ++round) {
      const auto walk = lod_walk(frames, some, settings_.size(), options, run.executor, run.cancel);
      if (!walk) throw std::runtime_error("cancelled");
      const std::vector<FrameSample> drawn = samples_of(*walk);
      if (round > 0 && fit_error(options.costs, drawn).mean < good) break;
      samples.insert(samples.end(), drawn.begin(), drawn.end());
      const evaluators::lod_walk::WalkFit fit = evaluators::lod_walk::walk_fit(samples);
      options.costs = fit_costs(samples, fit.max.mean < fit.sum.mean ? Stages::max : Stages::sum);
      options.methods = {Method::budget};
    }
    run.note(
        "fitted-costs",
        fmt::format("costs were fitted to {} frames before the walk ({}); to use others, name a file of them: costs = "
                    "FILE",
                    samples.size(), options.costs.stages == Stages::max ? "the slower stage counts" : "stages add up"));
    return options.costs;
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

  WalkSettings settings_;
};

}  // namespace

Plugin lod_walk_plugin() {
  OptionTable<WalkSettings> table;
  add_frame_rows(table);
  table.row(&WalkSettings::methods_text, "methods",
            "Which methods walk: none, static, feedback and budget, separated by spaces; the scene's own figures are "
            "those of the last one");
  table.number_or_text(
      &WalkSettings::costs_file, "costs",
      "File with what a triangle, a vertex and a pixel cost on the machine (default: an example's; where frames are "
      "drawn, fitted to some of them before the walk)",
      OptionType::views);
  table.row(&WalkSettings::budget, "budget", "Time of a frame (default: a share of what full detail costs)",
            {0.0001, 1e6, "ms"});
  table.row(&WalkSettings::share, "share", "Budget as a share of the mean cost of full detail", {0.001, 10, ""});
  table.choice(
      &WalkSettings::times, "times",
      "What frames take: what the model says, with noise; or what drawing them takes, on the processor or on a "
      "Vulkan device, which differs from run to run",
      {{"model", FrameTimes::model}, {"drawn", FrameTimes::drawn}, {"vulkan", FrameTimes::vulkan}});
  table.row(&WalkSettings::noise, "noise", "Largest difference of a frame's time from the model's", {0, 0.9, ""});
  table.row(&WalkSettings::occlusion, "occlusion", "Objects that others hide are neither chosen for nor drawn");
  table.row(&WalkSettings::renderings, "renderings", "Objects may be drawn without normal map, or unlit");
  table.row(&WalkSettings::pixels, "pixels",
            "Largest triangle of static, on the screen (default: as large as the budget asks for)",
            {0.001, 1e6, "pixels"});
  table.choice(&WalkSettings::accuracy, "accuracy",
               "What accuracies are taken from: what pictures of each object lose, the errors of its levels on the "
               "screen, or samples, its numbers of vertices",
               {{"pictures", Accuracy::pictures}, {"errors", Accuracy::errors}, {"samples", Accuracy::samples}});
  table.row(&WalkSettings::focus, "focus", "What an object in a corner is worth, relative to one in the middle",
            {0, 1, ""});
  table.row(&WalkSettings::motion, "motion", "What moves fast over the picture is worth less");
  table.row(&WalkSettings::hysteresis, "hysteresis",
            "Share taken off the loss of the way that an object had in the last frame, so that it stays; 0: nothing",
            {0, 1, ""});
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
              {"frame", "ms", "Mean time of a frame"},
              {"longest-frame", "ms", "Time of the longest frame", true, true},
              {"frame-deviation", "ms", "Standard deviation of the frames' times"},
              {"over-budget", "%", "Frames that take longer than the budget"},
              {"benefit", "% of the bound",
               "Benefit of what was chosen, of the most that any choice within the budget can have", false},
              {"switched", "of 1000 objects", "Objects whose level or rendering differs from the frame before"},
              {"selecting", "ms", "Time that the choice takes for a frame, where frames are drawn"},
              {"picture-error", "%", "Root mean square difference from full detail, of a channel's range"},
              {"picture-floor", "%", "The same between two pictures of full detail from samples in different places",
               true, false, true},
              {"model-error", "%", "Mean error of the model's time of a frame"},
              {"fitted-error", "%", "The same of a model that was fitted to every second frame, on the others"},
          },
  };
  plugin.device = [table](const Settings& settings) -> std::string {
    const FrameTimes times = table.read(settings).times;
    return times == FrameTimes::model ? "" : times == FrameTimes::drawn ? "the processor" : vulkan_device();
  };
  bind_options(plugin, std::move(table),
               [](const WalkSettings& settings) { return std::make_unique<LodWalkEvaluator>(settings); });
  return plugin;
}

}  // namespace foredraw
