#include <foredraw/io/scene_folder.h>

#include <foredraw/io/scene_file.h>

#include <algorithm>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return !b.empty() && fs::equivalent(a, b, error);
}

}  // namespace

std::optional<std::vector<fs::path>> scenes_below(const fs::path& folder, const fs::path& except,
                                                  Diagnostics& diagnostics) {
  std::vector<fs::path> scenes;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    std::error_code gone;
    if (at->is_directory(gone)) {
      if (is_same(at->path(), except)) at.disable_recursion_pending();
    } else if (is_scene_file(at->path())) {
      scenes.push_back(at->path().lexically_relative(folder));
    }
  }
  if (error) {
    diagnostics.error({.file = folder.string()}, "unreadable-folder", "can not be read: " + error.message(),
                      "see that you may read it and all folders below it");
    return std::nullopt;
  }
  if (scenes.empty()) {
    diagnostics.error({.file = folder.string()}, "no-scenes", "holds no scene, nor do the folders below it",
                      "scenes are files called .glb, .gltf, .obj, .ply, .off or .stl");
    return std::nullopt;
  }
  std::ranges::sort(scenes);
  return scenes;
}

}  // namespace foredraw
