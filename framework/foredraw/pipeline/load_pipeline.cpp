#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/presets.h>
#include <foredraw/platform/files.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

std::optional<std::vector<NamedPipeline>> load_preset(const std::string& argument, Diagnostics& diagnostics) {
  const std::string name = argument.substr(1);
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return parse_branches(preset.text, argument, diagnostics);
    names.emplace_back(preset.name);
  }
  const std::string_view near = nearest(name, names);
  diagnostics.error(
      {.file = argument}, "unknown-preset", fmt::format("there is no preset '{}'", name),
      near.empty() ? fmt::format("there are @{}", fmt::join(names, ", @")) : fmt::format("did you mean '@{}'?", near));
  return std::nullopt;
}

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none) && !fs::is_directory(path, none);
}

/// A lone word that no stage is called: with a slash or an extension.
bool looks_like_path(const std::string& text) {
  return text.find_first_of("(), \t\n\"'=") == std::string::npos && text.find_first_of("/.") != std::string::npos;
}

}  // namespace

std::optional<std::vector<NamedPipeline>> load_branches(const std::string& argument, Diagnostics& diagnostics) {
  if (argument.starts_with('@')) return load_preset(argument, diagnostics);
  if (argument.ends_with(".toml") || is_file(argument)) {
    const auto bytes = read_file(argument, diagnostics);
    if (!bytes) return std::nullopt;
    return parse_branches({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, argument, diagnostics);
  }
  if (looks_like_path(argument)) {
    diagnostics.error({.file = argument}, "no-such-file", "there is no such file",
                      "a pipeline is a TOML file, a preset such as @default, or stages such as \"weld, tipsify\"");
    return std::nullopt;
  }
  auto pipeline = parse_line(argument, diagnostics);
  if (!pipeline) return std::nullopt;
  return std::vector<NamedPipeline>{{argument, std::move(*pipeline)}};
}

std::optional<Pipeline> load_pipeline(const std::string& argument, Diagnostics& diagnostics) {
  return only_one(load_branches(argument, diagnostics), argument, diagnostics);
}

}  // namespace foredraw
