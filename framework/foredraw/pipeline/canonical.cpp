#include <foredraw/pipeline/canonical.h>

#include <foredraw/pipeline/named_files.h>
#include <foredraw/pipeline/parse.h>

#include <algorithm>

namespace foredraw {

namespace {

bool fits(const Settings& settings, const std::vector<OptionSpec>& rows) {
  return std::ranges::all_of(settings, [&](const auto& setting) {
    const auto row = std::ranges::find(rows, setting.first, &OptionSpec::name);
    return row != rows.end() && std::holds_alternative<OptionValue>(fit(*row, setting.second));
  });
}

/// What is wrong with a setting stays as it is: the planner says so.
void fill(Settings& settings, const std::vector<OptionSpec>& rows) {
  for (const OptionSpec& row : rows) {
    const auto setting = settings.find(row.name);
    if (setting == settings.end()) {
      if (!std::holds_alternative<std::monostate>(row.default_value)) settings.emplace(row.name, row.default_value);
    } else if (auto fitted = fit(row, setting->second); auto* value = std::get_if<OptionValue>(&fitted)) {
      setting->second = std::move(*value);
    }
  }
}

template <class Visit>
void each_stage(Pipeline& pipeline, const Registry& registry, Visit visit) {
  for (std::vector<Stage>* stages : {&pipeline.stages, &pipeline.measure}) {
    for (Stage& stage : *stages) {
      if (const Plugin* plugin = registry.find(stage.use)) visit(stage, plugin->options);
    }
  }
  const Plugin* plugin = pipeline.overdraw ? registry.find(pipeline.overdraw->use) : nullptr;
  if (plugin != nullptr) visit(*pipeline.overdraw, plugin->service_options);
}

}  // namespace

std::string canonical_text(const Pipeline& pipeline, const Registry& registry) {
  Pipeline whole = with_paths_from_here(pipeline, registry);
  whole.about.clear();
  each_stage(whole, registry, [](Stage& stage, const std::vector<OptionSpec>& rows) { fill(stage.settings, rows); });
  return print_file(whole);
}

std::vector<std::string> devices_in(const Pipeline& pipeline, const Registry& registry) {
  Pipeline whole = with_paths_from_here(pipeline, registry);
  std::vector<std::string> devices;
  each_stage(whole, registry, [&](Stage& stage, const std::vector<OptionSpec>& rows) {
    const Plugin* plugin = registry.find(stage.use);
    if (!plugin->device || !fits(stage.settings, rows)) return;
    fill(stage.settings, rows);
    if (std::string device = plugin->device(stage.settings); !device.empty()) {
      devices.push_back(stage.use + ": " + device);
    }
  });
  return devices;
}

std::vector<std::filesystem::path> files_named_in(const Pipeline& pipeline, const Registry& registry) {
  Pipeline here = with_paths_from_here(pipeline, registry);
  std::vector<std::filesystem::path> files;
  const auto add = [&](const OptionValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    std::error_code error;
    if (text != nullptr && std::filesystem::is_regular_file(*text, error)) files.emplace_back(*text);
  };
  each_stage(here, registry, [&](const Stage& stage, const std::vector<OptionSpec>&) {
    for (const auto& [name, value] : stage.settings) add(value);
  });
  add(here.views.views);
  add(here.frames.path);
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace foredraw
