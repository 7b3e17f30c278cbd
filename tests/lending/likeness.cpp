#include "likeness.h"

namespace foredraw::testing {

namespace {

struct Options {
  ScenePath reference;
  ImagePath picture;
};

double triangles_in(const Scene& scene) {
  double triangles = 0;
  for (const Draw& draw : scene.draws) triangles += static_cast<double>(draw.full().stream().triangle_count());
  return triangles;
}

class Likeness final : public Evaluator {
 public:
  explicit Likeness(Options options) : options_(std::move(options)) {}

  void evaluate(const Scene& scene, Run& run) const override {
    if (!options_.reference.path.empty()) {
      run.count("triangles-more", triangles_in(scene) - triangles_in(run.scene(options_.reference)));
    }
    if (!options_.picture.path.empty()) {
      const auto texels = run.analyses.decode(run.image(options_.picture));
      if (const auto* why = std::get_if<std::string>(&texels)) throw std::runtime_error(*why);
      const ImageFacts& facts = std::get<Texels>(texels).facts;
      run.count("texels", static_cast<double>(facts.width) * facts.height);
    }
  }

 private:
  Options options_;
};

}  // namespace

Plugin likeness_plugin() {
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card.name = "likeness";
  plugin.card.summary = "Counts what a scene has more than another one";
  plugin.card.reference = "a test of this project";
  plugin.card.metrics = {{"triangles-more", "triangles", "Triangles that the reference has not"},
                         {"texels", "texels", "Texels of the picture"}};
  OptionTable<Options> table;
  table.row(&Options::reference, "reference", "The scene to compare with");
  table.row(&Options::picture, "picture", "An image whose texels are counted");
  bind_options(plugin, std::move(table), [](const Options& options) { return std::make_unique<Likeness>(options); });
  return plugin;
}

}  // namespace foredraw::testing
