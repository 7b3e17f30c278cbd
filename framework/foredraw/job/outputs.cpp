#include <foredraw/job/outputs.h>

#include <foredraw/io/scene_file.h>
#include <foredraw/io/side_files.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/report/remap.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace foredraw {

namespace {

constexpr const char* remap = "remap";
constexpr const char* sprites = "sprites";

std::vector<std::string> kinds_of(const ProductRows& rows) {
  std::vector<std::string> kinds{remap, sprites};
  for (const auto& row : rows) {
    if (!row->card().side_files.empty()) kinds.push_back(row->card().name);
  }
  return kinds;
}

/// "level2"
std::optional<std::size_t> level_of(std::string_view kind) {
  constexpr std::string_view word = "level";
  if (!kind.starts_with(word)) return std::nullopt;
  kind.remove_prefix(word.size());
  std::size_t level = 0;
  const auto [end, mistake] = std::from_chars(kind.data(), kind.data() + kind.size(), level);
  return mistake == std::errc() && end == kind.data() + kind.size() ? std::optional(level) : std::nullopt;
}

bool has_kind_for(const JobOutput& kind, const std::filesystem::path& path) {
  if (kind.row) return side_file_kind(*kind.row, path).has_value();
  if (kind.level) return is_scene_file(path);
  return kind.kind == sprites ? is_sprite_output(path) : path.extension() == ".json";
}

/// A path without a kind that is no file of the scene itself: of the one kind that has such files. Sprites' are the
/// scene's own.
JobOutput with_kind(JobOutput output, const ProductRows& rows, Diagnostics& diagnostics) {
  std::vector<JobOutput> fitting;
  for (const std::string& kind : kinds_of(rows)) {
    JobOutput one = typed_output(kind + ':' + output.path, rows);
    if (kind != sprites && has_kind_for(one, one.path)) fitting.push_back(std::move(one));
  }
  if (fitting.size() == 1) return fitting.front();
  const std::size_t colon = output.path.find(':');
  if (fitting.size() > 1 && colon != std::string::npos && colon > 1) {  // C: is a drive
    diagnostics.error({}, "unknown-kind", fmt::format("there is no kind of output '{}'", output.path.substr(0, colon)),
                      fmt::format("there are {}", kinds_text(rows)));
  } else if (fitting.size() > 1) {
    std::vector<std::string> words;
    for (const JobOutput& one : fitting) words.push_back(fmt::format("-o {}:{}", one.kind, one.path));
    diagnostics.error({.file = output.path}, "unknown-kind", "several kinds of output have this extension",
                      fmt::format("choose one: {}", fmt::join(words, ", ")));
  }
  return output;
}

}  // namespace

JobOutput typed_output(const std::string& word, const ProductRows& rows) {
  const std::size_t colon = word.find(':');
  const std::string kind = word.substr(0, colon);
  if (const auto level = level_of(kind); level && colon != std::string::npos) {
    return {kind, word.substr(colon + 1), nullptr, level};
  }
  if (colon == std::string::npos || !std::ranges::count(kinds_of(rows), kind)) return {{}, word};
  JobOutput output{kind, word.substr(colon + 1)};
  for (const auto& row : rows) {
    if (row->card().name == kind) output.row = row;
  }
  return output;
}

std::string kinds_text(const ProductRows& rows) { return fmt::format("{}, levelN", fmt::join(kinds_of(rows), ", ")); }

std::vector<JobOutput> outputs_of(const std::vector<std::string>& words, const std::string& input,
                                  const ProductRows& rows, Diagnostics& diagnostics) {
  std::vector<JobOutput> outputs;
  for (const std::string& word : words) {
    JobOutput output = typed_output(word, rows);
    const bool is_of_sprites = input != "-" && is_sprite_input(input);
    const bool is_scenes =
        output.path == "-" || is_scene_file(output.path) || (is_of_sprites && is_sprite_output(output.path));
    if (output.kind.empty() && !is_scenes && !std::filesystem::is_directory(input))
      output = with_kind(std::move(output), rows, diagnostics);
    if (!output.kind.empty() && !has_kind_for(output, output.path)) {
      diagnostics.error({.file = output.path}, "unknown-kind",
                        fmt::format("'{}' cannot be written with this extension", output.kind),
                        "foredraw optimize --help lists the kinds of output");
    }
    outputs.push_back(std::move(output));
  }
  return outputs;
}

std::vector<std::filesystem::path> paths_written_for(const JobOutput& output) {
  if (output.row) return paths_of_side_file(*output.row, output.path);
  return output.kind.empty() || output.level ? paths_written_for(std::filesystem::path(output.path))
                                             : std::vector<std::filesystem::path>{output.path};
}

bool can_write(const std::vector<JobOutput>& outputs, const std::string& input, Diagnostics& diagnostics) {
  bool good = true;
  for (const JobOutput& output : outputs) {
    if (output.is_scene()) good = can_write_scene(output.path, input, diagnostics) && good;
  }
  return good;
}

bool have_folders(const std::vector<std::string>& files, Diagnostics& diagnostics) {
  std::error_code none;
  for (const std::string& file : files) {
    const auto folder = std::filesystem::path(file).parent_path();
    if (folder.empty() || std::filesystem::is_directory(folder, none)) continue;
    diagnostics.error({.file = file}, "no-such-folder",
                      "cannot be written: there is no folder '" + folder.string() + "'",
                      "create it, or name another folder");
  }
  return !diagnostics.has_errors();
}

std::optional<std::vector<OutputFile>> encode(const Scene& scene, const JobOutput& output,
                                              const OutputSettings& settings, const ProductRows& rows,
                                              Diagnostics& diagnostics) {
  if (output.row) return encode_side_file(scene, *output.row, output.path, diagnostics);
  if (output.kind == remap) {
    const std::string text = remap_json(scene);
    const auto bytes = std::as_bytes(std::span(text));
    return std::vector<OutputFile>{{output.path, {bytes.begin(), bytes.end()}}};
  }
  const GltfOutput as{.compression = settings.compression,
                      .turns_corners = settings.turns_corners,
                      .levels = settings.levels,
                      .products = rows};
  const auto written = [&](const Scene& one) {
    return output.level ? encode_level(one, *output.level, output.path, diagnostics, as)
                        : encode_scene(one, output.path, diagnostics, as);
  };
  if (settings.has_products || scene.products.empty()) return written(scene);
  Scene bare = scene;
  for (const auto& row : rows) {
    if (bare.products.has(row->card().name)) row->leave_out(bare);
  }
  return written(bare);
}

std::optional<std::vector<OutputFile>> encode_together(std::span<const Scene> scenes,
                                                       const std::vector<std::string>& paths,
                                                       Diagnostics& diagnostics) {
  std::vector<OutputFile> files;
  for (const std::string& path : paths) {
    auto file = encode_sprites(scenes, path, diagnostics);
    if (!file) return std::nullopt;
    files.push_back(std::move(*file));
  }
  return files;
}

}  // namespace foredraw
