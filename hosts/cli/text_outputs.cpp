#include "text_outputs.h"

#include "session.h"

#include <foredraw/io/sprite/sprite_files.h>

#include <algorithm>
#include <array>

namespace foredraw::cli {

namespace {

constexpr std::array<std::string_view, 19> kinds_of_assets = {".glb", ".gltf", ".bin", ".obj", ".mtl",  ".ply", ".off",
                                                              ".stl", ".toml", ".png", ".jpg", ".jpeg", ".tga", ".webp",
                                                              ".exr", ".ktx2", ".dds", ".hdr", ".bmp"};

bool is_called_like_an_asset(const std::string& file) {
  std::string kind = std::filesystem::path(file).extension().string();
  std::ranges::transform(kind, kind.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::ranges::find(kinds_of_assets, kind) != kinds_of_assets.end();
}

bool is_among(const std::vector<std::string>& files, const std::string& file) {
  return std::ranges::any_of(files, [&](const std::string& other) { return is_same_file(other, file); });
}

/// Whether no scene that is to be written takes a file of another, and no file of sprites one that is read: a picture
/// of an image is not what the image is.
void check_outputs(const std::vector<JobOutput>& outputs, const std::vector<std::string>& read,
                   Diagnostics& diagnostics) {
  std::vector<std::string> taken;
  for (const JobOutput& output : outputs) {
    const bool is_standard = output.path == "-";
    std::vector<std::string> files;
    for (const auto& path : paths_written_for(output)) files.push_back(path.string());
    if ((!output.kind.empty() || is_sprite_output(output.path)) && is_among(read, output.path)) {
      diagnostics.error({.file = output.path}, "bad-arguments", "is an input of this run",
                        "give the output another name or folder");
    }
    const auto is_taken = [&](const std::string& file) {
      return is_standard ? std::ranges::find(taken, file) != taken.end() : is_among(taken, file);
    };
    const bool meets = std::ranges::any_of(files, is_taken);
    if (meets) {
      diagnostics.error({.file = is_standard ? "" : output.path}, "bad-arguments", "is named for two outputs",
                        "give each -o a file of its own");
    }
    taken.insert(taken.end(), files.begin(), files.end());
  }
}

}  // namespace

std::vector<std::string> files_read(const CommonArguments& arguments, const PipelineArguments& pipelines) {
  std::vector<std::string> read = arguments.inputs;
  read.insert(read.end(), pipelines.pipelines.begin(), pipelines.pipelines.end());
  return read;
}

bool have_files_of_their_own(std::vector<std::string> read, const std::vector<JobOutput>& outputs,
                             const TextArguments& texts, Diagnostics& diagnostics) {
  if (!texts.baseline.empty()) read.push_back(texts.baseline);
  check_outputs(outputs, read, diagnostics);
  std::vector<std::string> written;
  for (const JobOutput& output : outputs) written.push_back(output.path);
  const auto refuse = [&](const std::string& file, const char* why, const char* hint) {
    diagnostics.error({.file = file}, "bad-arguments", why, hint);
  };
  for (const std::string& file : {texts.report, texts.csv, texts.html, texts.depfile}) {
    if (file.empty()) continue;
    if (file == "-") {
      refuse("", "--report, --csv, --html and --depfile take the name of a file",
             "use --json to print to standard output");
    } else if (is_among(read, file)) {
      refuse(file, "is an input of this run", "give the output a file of its own");
    } else if (is_among(written, file)) {
      refuse(file, "is named for two outputs", "give each a file of its own");
    } else if (is_called_like_an_asset(file)) {
      refuse(file, "has the extension of a scene, of a part of one, or of a pipeline, but would hold text",
             "use a name that ends in .json, .csv or .html");
    }
    written.push_back(file);
  }
  return !diagnostics.has_errors();
}

}  // namespace foredraw::cli
