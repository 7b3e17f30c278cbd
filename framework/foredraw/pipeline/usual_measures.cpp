#include <foredraw/pipeline/usual_measures.h>

#include <foredraw/pipeline/parse.h>

#include <algorithm>

namespace foredraw {

namespace {

std::vector<Stage> measures_of_default() {
  Diagnostics none;
  return load_pipeline("@default", none).value().measure;
}

/// Those that the plugin's card names.
std::vector<Stage> measures_of(const Plugin* plugin, const Registry& registry) {
  std::vector<Stage> measures;
  for (const std::string& name : plugin == nullptr ? std::vector<std::string>() : plugin->card.measured_by) {
    if (registry.find(name) != nullptr) measures.push_back({.use = name});
  }
  return measures;
}

}  // namespace

std::vector<Stage> usual_measures(const std::vector<Stage>& stages, const Registry& registry) {
  std::vector<Stage> measures;
  const auto add = [&](const std::vector<Stage>& more) {
    for (const Stage& one : more) {
      if (std::ranges::find(measures, one.use, &Stage::use) == measures.end()) measures.push_back(one);
    }
  };
  const std::vector<Stage> of_default = measures_of_default();
  for (const Stage& stage : stages) {
    if (!stage.enabled) continue;
    const std::vector<Stage> own = measures_of(registry.find(stage.use), registry);
    add(own.empty() ? of_default : own);
  }
  if (measures.empty()) add(of_default);
  return measures;
}

}  // namespace foredraw
