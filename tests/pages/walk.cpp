#include "walk.h"

#include <limits>

namespace foredraw::testing {

namespace {

struct Options {
  int frames = 24;
};

double triangles_in(const Scene& scene) {
  double triangles = 0;
  for (const Draw& draw : scene.draws) triangles += static_cast<double>(draw.full().stream().triangle_count());
  return triangles;
}

std::vector<std::uint8_t> filled(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < width * height; ++i) rgb.insert(rgb.end(), {red, green, blue});
  return rgb;
}

class Walk final : public Evaluator {
 public:
  explicit Walk(Options options) : options_(options) {}

  void evaluate(const Scene& scene, Run& run) const override {
    const double triangles = triangles_in(scene);
    Chart cost{"cost", "as if it were measured", "frame", "time of a frame", "ms", {}, {{"budget", 10}}};
    Chart switches{"switches", "", "frame", "switches in a frame", "", {}, {}};
    Film steady{"steady", "the lighter, the later", 16, 9, {}}, eager{"<b>eager</b>", "", 16, 9, {}};
    cost.lines = switches.lines = {{"steady", {}}, {"<b>eager</b>", {}}};
    for (int frame = 0; frame < options_.frames; ++frame) {
      const bool is_gap = frame >= 9 && frame < 12;
      cost.lines[0].values.push_back(4 + triangles / 2000);
      cost.lines[1].values.push_back(is_gap ? std::numeric_limits<double>::quiet_NaN()
                                            : (frame + 1) * triangles / 6000);
      switches.lines[0].values.push_back(frame % 2);
      switches.lines[1].values.push_back(1000 + frame);
      const auto light = static_cast<std::uint8_t>(10 * frame);
      steady.frames.push_back(filled(16, 9, light, light, light));
      eager.frames.push_back(filled(16, 9, light, 0, 40));
    }
    run.attach(std::move(cost));
    run.attach(std::move(steady));
    run.attach(std::move(switches));
    run.attach(std::move(eager));
    run.attach_at({.draw = 0, .subject = {}}, Film{"portrait", "once", 300, 100, {filled(300, 100, 9, 200, 9)}});
  }

 private:
  Options options_;
};

}  // namespace

Plugin walk_plugin() {
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card.name = "walk";
  plugin.card.summary = "Attaches what a page shows frame by frame";
  plugin.card.reference = "a test of this project";
  OptionTable<Options> table;
  table.row(&Options::frames, "frames", "How many frames", {.least = 1, .most = 25});
  bind_options(plugin, std::move(table), [](const Options& options) { return std::make_unique<Walk>(options); });
  return plugin;
}

}  // namespace foredraw::testing
