#include "every_plugin.h"

#include "all_plugins.h"
#include "odd_scenes.h"
#include "support/sprite_scenes.h"

#include <algorithm>

namespace foredraw::testing {

namespace {

/// Lends whatever is asked for.
class Generous final : public Lender {
 public:
  std::optional<Loan<Scene>> scene(const std::string&, Diagnostics&) const override {
    return Loan<Scene>{std::make_shared<const Scene>(odd_scene()), 1, {}};
  }
  std::optional<Loan<Image>> image(const std::string&, Diagnostics&) const override {
    return Loan<Image>{std::make_shared<const Image>(odd_scene().images.front()), 1, {}};
  }
};

}  // namespace

const Registry& registry() {
  static const Registry all = [] {
    Registry registry;
    add_all_plugins(registry);
    return registry;
  }();
  return all;
}

Pipeline pipeline_for(const Plugin& plugin, const Settings& settings) {
  Pipeline pipeline;
  Stage stage;
  stage.use = plugin.card.name;
  stage.settings = settings;
  if (plugin.kind == Kind::evaluator) {
    pipeline.measure.push_back(stage);
    return pipeline;
  }
  for (const std::string& need : plugin.card.needs) {
    for (const Plugin* other : registry().all()) {
      if (!other->card.provides.has(need)) continue;
      pipeline.stages.push_back({.use = other->card.name});
      break;
    }
  }
  pipeline.stages.push_back(stage);
  return pipeline;
}

Outcome run(Pipeline pipeline, int threads) {
  pipeline.views.count = 12;
  pipeline.views.size = 48;
  Diagnostics diagnostics;
  const Scene scene = odd_scene();
  const Generous lender;
  auto plan = foredraw::plan(pipeline, registry(), scene, diagnostics, &lender);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(threads);
  Analyses analyses(stored_texels());
  Result result = foredraw::optimize(*plan, scene, {executor, analyses});
  return {std::move(result), std::move(*plan)};
}

std::string problems(const Result& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.report.diagnostics) text += to_text(diagnostic) + '\n';
  return text;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryPlugin, ::testing::ValuesIn(registry().names()), test_name);

}  // namespace foredraw::testing
