#include <foredraw/io/scene_file.h>

#include <foredraw/io/gltf.h>

#include <algorithm>
#include <cctype>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

std::string kind_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

fs::path folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

std::optional<SceneFile> read_scene(const std::string& path, Diagnostics& diagnostics) {
  if (path.empty()) {
    diagnostics.error({}, "no-such-file", "the input's name is empty", "give the path of a .glb or .gltf, or -");
    return std::nullopt;
  }
  const bool is_standard = path == "-";
  const auto bytes = is_standard ? read_standard_input(diagnostics) : read_file(path, diagnostics);
  if (!bytes) return std::nullopt;
  auto scene = is_standard ? read_gltf(*bytes, "standard input", {}, diagnostics)
                           : read_gltf(*bytes, path, folder_of(path), diagnostics);
  if (!scene) return std::nullopt;
  return SceneFile{std::move(*scene), bytes->size()};
}

bool can_write_scene(const std::string& path, Diagnostics& diagnostics) {
  if (path == "-" || kind_of(path) == ".glb" || kind_of(path) == ".gltf") return true;
  diagnostics.error({.file = path}, "unknown-kind", "scenes are written as .glb or .gltf",
                    "give the output one of these extensions, or - for a GLB on standard output");
  return false;
}

std::optional<std::vector<OutputFile>> encode_scene(const Scene& scene, const std::string& path,
                                                    Diagnostics& diagnostics, Compression compression) {
  if (!can_write_scene(path, diagnostics)) return std::nullopt;
  const bool is_standard = path == "-";
  auto files = encode_gltf(scene, is_standard ? "standard output.glb" : path, diagnostics, compression);
  if (!files || !is_standard) return files;
  if (files->size() > 1) {
    diagnostics.error({.file = "standard output"}, "several-files",
                      "the scene takes several files, and standard output holds one",
                      "give -o the name of a file; plain copies of compressed data are left out by --compression none");
    return std::nullopt;
  }
  files->front().path = path;
  return files;
}

}  // namespace foredraw
