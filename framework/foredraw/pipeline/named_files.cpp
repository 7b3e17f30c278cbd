#include <foredraw/pipeline/named_files.h>

#include <foredraw/scene/views.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace foredraw {

namespace {

std::string from_here(const std::string& path, const Where& written_at) {
  return (std::filesystem::path(written_at.file).parent_path() / path).string();
}

Where place_of(const Stage& stage, const std::string& option) {
  const auto at = stage.option_where.find(option);
  return at == stage.option_where.end() ? stage.where : at->second;
}

void resolve(Stage& stage, const std::vector<OptionSpec>& rows) {
  for (auto& [name, value] : stage.settings) {
    const auto row = std::ranges::find(rows, name, &OptionSpec::name);
    if (row == rows.end() || !names_file(*row, value)) continue;
    value = from_here(std::get<std::string>(value), place_of(stage, name));
  }
}

/// Whether `loans` has it now.
template <class Content, class Read>
bool is_lent(const std::string& path, std::map<std::string, Loan<Content>>& loans, Read read) {
  if (loans.contains(path)) return true;
  auto loan = read();
  if (loan) loans.emplace(path, std::move(*loan));
  return loan.has_value();
}

}  // namespace

Pipeline with_paths_from_here(Pipeline pipeline, const Registry& registry) {
  for (std::vector<Stage>* stages : {&pipeline.stages, &pipeline.measure}) {
    for (Stage& stage : *stages) {
      if (const Plugin* plugin = registry.find(stage.use)) resolve(stage, plugin->options);
    }
  }
  if (pipeline.overdraw) {
    if (const Plugin* plugin = registry.find(pipeline.overdraw->use))
      resolve(*pipeline.overdraw, plugin->service_options);
  }
  if (is_view_list(pipeline.views.views)) pipeline.views.views = from_here(pipeline.views.views, pipeline.views_where);
  if (is_camera_file(pipeline.frames.path)) {
    pipeline.frames.path = from_here(pipeline.frames.path, pipeline.frames_where);
  }
  return pipeline;
}

bool borrow(const Stage& stage, const std::vector<OptionSpec>& rows, const Settings& settings, const Lender* lender,
            Loans& loans, Diagnostics& diagnostics) {
  bool good = true;
  for (const OptionSpec& row : rows) {
    const auto setting = settings.find(row.name);
    const bool is_scene = row.type == OptionType::scene;
    if (setting == settings.end() || !(is_scene || row.type == OptionType::image)) continue;
    const auto& path = std::get<std::string>(setting->second);
    Diagnostics reading;
    const auto refuse = [&](std::string why, std::string hint) {
      diagnostics.error(place_of(stage, row.name), "nothing-lent",
                        fmt::format("'{}' of '{}': {}", row.name, stage.use, why), std::move(hint));
      good = false;
    };
    if (lender == nullptr) {
      refuse(path + " is not read: this program cannot read files that options name", "leave the option out");
    } else if (!(is_scene ? is_lent(path, loans.scenes, [&] { return lender->scene(path, reading); })
                          : is_lent(path, loans.images, [&] { return lender->image(path, reading); }))) {
      refuse(path + " cannot be read", fmt::format("name {} that can be read", is_scene ? "a scene" : "an image"));
    }
    for (const Diagnostic& found : reading.all()) {
      if (found.severity != Severity::note) diagnostics.add(found);
    }
  }
  return good;
}

}  // namespace foredraw
