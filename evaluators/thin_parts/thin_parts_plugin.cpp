#include "thin_parts.h"

#include <foredraw/frames/sliding_views.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foredraw {

namespace {

constexpr double percent = 100;
constexpr double part_of_picture = 0.8;  ///< that the scene's sphere takes
constexpr double least_part = 0.05;      ///< of what is seen that is narrower than the least feature
constexpr int halvings = 4;

struct ThinPartsSettings {
  int size = 205;
  int views = 8;
};

class ThinPartsEvaluator final : public Evaluator {
 public:
  explicit ThinPartsEvaluator(const ThinPartsSettings& settings) : settings_(settings) {}

  void evaluate(const Scene& scene, Run& run) const override {
    const FrameScene frames(scene, run.analyses, run.executor);
    if (frames.objects().empty()) return run.note("nothing-to-see", "no node shows triangles");
    const FrameMoment moment = frame_moment(frames, 0);
    const SurfaceShares shares = surface_shares(frames, moment);
    if (shares.area > 0) {
      run.measure("closed-area", percent * shares.closed, shares.area);
      run.measure("wire-share", percent * shares.wires, shares.area);
    }
    Chart chart{
        "thinner than a pixel",
        fmt::format("Of what is seen of the scene. In frame 1 the sphere around it is {} pixels wide, and in each "
                    "after that half as wide.",
                    settings_.size),
        "frame",
        "part",
        "%",
        {{"sub-pixel", {}}},
        {}};
    for (int halving = 0; halving < halvings; ++halving) {
      const int across = settings_.size >> halving;
      if (across < 8) break;
      const auto parts = measure(frames, moment, across, halving == 0, run);
      if (!parts) throw std::runtime_error("cancelled");
      chart.lines.front().values.push_back(*parts);
      if (run.progress) run.progress((halving + 1.0) / halvings);
    }
    run.attach(std::move(chart));
  }

 private:
  /// Per cent that is thinner than a pixel; none: cancelled.
  std::optional<double> measure(const FrameScene& frames, const FrameMoment& moment, int across, bool is_own,
                                const Run& run) const {
    const int edge = static_cast<int>(std::lround(across / part_of_picture));
    const FrameSize size{edge, edge};
    const SlidingViews views = sliding_views(frames, moment, size, across, settings_.views, 1, 0, run.seed);
    std::vector<SeenWidths> widths(views.size());
    run.executor.for_each(views.size(), [&](std::size_t v) {
      if (!run.cancelled()) widths[v] = seen_widths(frames, moment, views[v].front(), size);
    });
    if (run.cancelled()) return std::nullopt;
    SeenWidths all;
    for (const SeenWidths& of : widths) all.add(of);
    const double thin = all.thinner_than(1), seen = all.seen(), part = seen > 0 ? thin / seen : 0;
    double squares = 0;  // of what each view's part is off, weighted by what it shows
    for (const SeenWidths& of : widths) {
      const double off = of.thinner_than(1) - part * of.seen();
      squares += off * off;
    }
    const double error = seen > 0 ? std::sqrt(squares) / seen : 0;
    const std::string group = is_own ? "" : fmt::format("{}-px.", across);
    run.measure(group + "sub-pixel", percent * thin, std::max(seen, 1.0), percent * error);
    run.measure(group + "least-feature", all.width_of(least_part), 1);
    run.note("thin", fmt::format("{} pixels across: {:.2f} % ±{:.2f} of what is seen is thinner than a pixel, and a "
                                 "twentieth is thinner than {:.2f} pixels",
                                 across, percent * part, percent * error, all.width_of(least_part)));
    return percent * part;
  }

  ThinPartsSettings settings_;
};

}  // namespace

Plugin thin_parts_plugin() {
  OptionTable<ThinPartsSettings> table;
  table.row(&ThinPartsSettings::size, "size",
            "How large the sphere around the scene is in the largest pictures; in the next ones it is half as large, "
            "and so on",
            {16, 800, "pixels"});
  table.row(&ThinPartsSettings::views, "views", "From how many places the scene is seen", {1, 1000, "views"});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "thin-parts",
      .summary = "Measures how much of a scene is thinner than a pixel, closed, or a wire",
      .reference = "Persson 2012",
      .metrics =
          {
              {"sub-pixel", "%", "Share of what is seen that is thinner than a pixel", true, false, true},
              {"least-feature", "pixels", "Width that a twentieth of what is seen is narrower than", false, false,
               true},
              {"closed-area", "%", "Surface of closed bodies, welded by positions", false, false, true},
              {"wire-share", "%", "Surface whose vertices store a wire", false, false, true},
          },
  };
  bind_options(plugin, std::move(table),
               [](const ThinPartsSettings& settings) { return std::make_unique<ThinPartsEvaluator>(settings); });
  return plugin;
}

}  // namespace foredraw
