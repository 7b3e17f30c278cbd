#include "antialiasing.h"

#include <foredraw/frames/picture_error.h>
#include <foredraw/shells/second_depth.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

using evaluators::antialiasing::Way;

struct AntialiasingSettings {
  std::string ways =
      "msaa-4 none msaa-2 msaa-8 post second-depth wire-clamp wire-clamp-msaa-4 wire-coverage wire-coverage-msaa-4";
  int size = 205;
  int views = 4;
  int frames = 4;
  double step = 0.37;
  int truth_samples = 256;
};

constexpr double part_of_picture = 0.8;  ///< that the scene's sphere takes
constexpr double percent = 100;

std::vector<Way> ways_in(const std::string& text) {
  std::vector<Way> ways;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const auto found =
        std::ranges::find(evaluators::antialiasing::all_ways, word, [](Way way) { return to_text(way); });
    if (found == evaluators::antialiasing::all_ways.end()) {
      throw std::invalid_argument(fmt::format(
          "'{}' is not one of the ways; expected none, msaa-2, msaa-4, msaa-8, post, second-depth, wire-clamp, "
          "wire-clamp-msaa-4, wire-coverage or wire-coverage-msaa-4, separated by spaces",
          word));
    }
    if (std::ranges::find(ways, *found) == ways.end()) ways.push_back(*found);
  }
  if (ways.empty()) throw std::invalid_argument("ways is empty; name at least one, such as msaa-4");
  return ways;
}

double decibels(double rmse) { return rmse > 0 ? -20 * std::log10(rmse) : 99; }

void measure(const Antialiasing::OfWay& of, bool has_wires, const std::string& group, const Run& run) {
  const auto figure = [&](const char* name, const AntialiasingFigure& f) {
    run.measure(group + name, percent * f.value, 1, percent * f.error);
  };
  figure("rmse", of.rmse);
  figure("flicker", of.flicker);
  run.measure(group + "psnr", decibels(of.rmse.value), 1,
              of.rmse.value > 0 ? 20 / std::log(10.0) * of.rmse.error / of.rmse.value : 0);
  if (!has_wires) return;
  figure("broken", of.broken);
  figure("ink", of.ink);
}

void tell(const Antialiasing& found, const Run& run) {
  for (const Antialiasing::OfWay& of : found.ways) {
    std::string text =
        fmt::format("{}: rmse {:.2f} % ±{:.2f}, flicker {:.2f} % ±{:.2f}", to_text(of.way), percent * of.rmse.value,
                    percent * of.rmse.error, percent * of.flicker.value, percent * of.flicker.error);
    if (found.has_wires) {
      text +=
          fmt::format("; of wires {:.1f} % broken, ink {:+.1f} %", percent * of.broken.value, percent * of.ink.value);
    }
    run.note("way", text);
  }
  run.note("truth", fmt::format("two truths differ by {:.2f} % ±{:.2f}; {:.1f} % of all pixels lie at edges and count",
                                percent * found.floor.value, percent * found.floor.error, percent * found.touched));
}

class AntialiasingEvaluator final : public Evaluator {
 public:
  explicit AntialiasingEvaluator(const AntialiasingSettings& settings)
      : settings_(settings), ways_(ways_in(settings.ways)) {
    if (!std::has_single_bit(static_cast<unsigned>(settings.truth_samples))) {
      throw std::invalid_argument(fmt::format("truth-samples is {}, but must be a power of two, such as 64, 128 or 256",
                                              settings.truth_samples));
    }
  }

  void evaluate(const Scene& scene, Run& run) const override {
    const FrameScene frames(scene, run.analyses, run.executor);
    if (frames.objects().empty()) return run.note("nothing-to-see", "no node shows triangles");
    const FrameMoment moment = frame_moment(frames, 0);
    const int edge = static_cast<int>(std::lround(settings_.size / part_of_picture));
    AntialiasingOptions options{.size = {edge, edge}, .truth_samples = settings_.truth_samples, .ways = ways_};
    std::vector<std::uint32_t> closed(scene.draws.size());
    if (const auto* product = scene.products.find<SecondDepth>()) {
      for (const SecondDepth::OfDraw& of : product->draws) closed[of.draw] = of.triangles;
      options.closed = &closed;
    }
    const SlidingViews views = sliding_views(frames, moment, options.size, settings_.size, settings_.views,
                                             settings_.frames, settings_.step, run.seed);
    const auto found = antialiasing(frames, moment, views, options, run.executor, run.cancel, run.progress);
    if (!found) throw std::runtime_error("cancelled");
    for (const Antialiasing::OfWay& of : found->ways) {
      measure(of, found->has_wires, std::string(to_text(of.way)) + '.', run);
      if (of.way == ways_.front()) measure(of, found->has_wires, "", run);
    }
    run.measure("floor", percent * found->floor.value, 1, percent * found->floor.error);
    tell(*found, run);
    say_what_is_skipped(*found, run);
    const auto show = [&](std::string name, const FramePicture& picture) {
      run.attach(Film{std::move(name), "The first view.", edge, edge, {as_rgb(picture)}});
    };
    for (const Antialiasing::OfWay& of : found->ways) show(std::string(to_text(of.way)), of.picture);
    show("truth", found->truth);
  }

 private:
  void say_what_is_skipped(const Antialiasing& found, const Run& run) const {
    const auto is_left_out = [&](Way way) {
      return std::ranges::find(ways_, way) != ways_.end() &&
             std::ranges::find(found.ways, way, &Antialiasing::OfWay::way) == found.ways.end();
    };
    if (std::ranges::any_of(ways_,
                            [&](Way way) { return evaluators::antialiasing::is_for_wires(way) && is_left_out(way); })) {
      run.note("no-wires", "no vertex stores a wire, so the ways for wires are left out; put wire-radius before it");
    }
    if (is_left_out(Way::second_depth)) {
      run.note("no-second-depth",
               "no draw stores which of its triangles are closed, so the way second-depth is left out; put the stage "
               "second-depth before it");
    }
  }

  AntialiasingSettings settings_;
  std::vector<Way> ways_;
};

}  // namespace

Plugin antialiasing_plugin() {
  OptionTable<AntialiasingSettings> table;
  table.row(&AntialiasingSettings::ways, "ways",
            "What is compared: none, msaa-2, msaa-4, msaa-8, post (a filter like FXAA), second-depth, wire-clamp, "
            "wire-clamp-msaa-4, wire-coverage and wire-coverage-msaa-4, separated by spaces; the scene's own figures "
            "are those of the first");
  table.row(&AntialiasingSettings::size, "size", "How large the sphere around the scene is in the pictures",
            {16, 3000, "pixels"});
  table.row(&AntialiasingSettings::views, "views", "From how many places the scene is seen", {1, 1000, "views"});
  table.row(&AntialiasingSettings::frames, "frames", "Frames from each place, while the camera slides sideways",
            {1, 1000, "frames"});
  table.row(&AntialiasingSettings::step, "step", "How far it slides from frame to frame", {0, 10, "pixels"});
  table.row(&AntialiasingSettings::truth_samples, "truth-samples",
            "Samples of each pixel of the truth, a power of two; two truths differ by about 1 / samples",
            {16, 65536, "samples"});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "antialiasing",
      .summary =
          "Compares ways to smooth jagged edges with a supersampled truth, while the camera moves by parts of a pixel",
      .reference = "Persson 2012",
      .metrics =
          {
              {"rmse", "%", "Root mean square difference from the truth at edges, of a linear channel's range"},
              {"psnr", "dB", "The same error as a signal-to-noise ratio", false},
              {"flicker", "%", "Root mean square of how far changes from frame to frame differ from the truth's"},
              {"broken", "%", "Pixels of wires with less than half of the contrast that they should have"},
              {"ink", "%", "How much more of the wires is drawn than there is", true, false, true},
              {"floor", "%", "Root mean square difference between two truths", true, false, true},
          },
  };
  bind_options(plugin, std::move(table),
               [](const AntialiasingSettings& settings) { return std::make_unique<AntialiasingEvaluator>(settings); });
  return plugin;
}

}  // namespace foredraw
