#include "scene_folder.h"

#include <foredraw/base/printable.h>
#include <foredraw/io/imported_file.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/io/scene_kinds.h>
#include <foredraw/io/sprite/sprite_files.h>

#include <algorithm>
#include <array>
#include <set>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return !b.empty() && fs::equivalent(a, b, error);
}

/// Without the images that its lists name.
void drop_images_of_lists(const fs::path& folder, std::vector<fs::path>& scenes) {
  std::set<fs::path> named;
  std::erase_if(scenes, [&](const fs::path& scene) {
    if (!is_frame_list(scene)) return false;
    const auto images = images_of_list(folder / scene);
    for (const fs::path& image : images.value_or(std::vector<fs::path>{})) named.insert(image.lexically_normal());
    return !images;
  });
  std::erase_if(scenes, [&](const fs::path& scene) { return named.contains((folder / scene).lexically_normal()); });
}

}  // namespace

bool works_on_sprites(const Pipeline& pipeline, const Registry& registry) {
  const auto does = [&](const Stage& stage) {
    const Plugin* plugin = stage.enabled ? registry.find(stage.use) : nullptr;
    return plugin != nullptr && plugin->card.acts_on.has(traits::sprite);
  };
  return std::ranges::any_of(pipeline.stages, does) || std::ranges::any_of(pipeline.measure, does);
}

FolderScenes scenes_for(bool works_on_sprites) { return {works_on_sprites, !import_limits().importer.empty()}; }

bool is_scene_of_folder(const fs::path& file, const FolderScenes& which) {
  if (is_scene_file(file)) return true;
  if (!which.with_imported || !is_imported_file(file)) return false;
  std::error_code error;
  return std::ranges::none_of(std::array{".glb", ".gltf"}, [&](const char* extension) {
    return fs::exists(fs::path(file).replace_extension(extension), error);
  });
}

std::optional<std::vector<fs::path>> scenes_below(const fs::path& folder, const fs::path& except,
                                                  const FolderScenes& which, Diagnostics& diagnostics) {
  std::vector<fs::path> scenes;
  bool has_images = false;
  std::string not_imported;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    std::error_code gone;
    if (at->is_directory(gone)) {
      if (is_same(at->path(), except)) at.disable_recursion_pending();
    } else if (is_scene_of_folder(at->path(), which) || (which.with_sprites && is_sprite_input(at->path()))) {
      fs::path scene = at->path().lexically_relative(folder);
      if (is_utf8(scene.native())) {
        scenes.push_back(std::move(scene));
      } else {
        diagnostics.warning({.file = printable(at->path().string())}, "name-not-utf-8",
                            "is passed by: its name is not UTF-8, which reports and glTF need", "give it another name");
      }
    } else {
      if (!which.with_imported && not_imported.empty() && is_imported_file(at->path())) {
        not_imported = at->path().string();
      }
      has_images = has_images || (is_sprite_input(at->path()) && !is_frame_list(at->path()));
    }
  }
  if (error) {
    diagnostics.error({.file = folder.string()}, "unreadable-folder", "cannot be read: " + error.message(),
                      "check that you may read it and all folders below it");
    return std::nullopt;
  }
  drop_images_of_lists(folder, scenes);
  if (!not_imported.empty()) {
    diagnostics.note({.file = printable(not_imported)}, "no-importer",
                     "is passed by, and so are files like it: foredraw-import is not installed");
  }
  if (scenes.empty()) {
    const std::string meshes = "scenes are files with the extensions " + extensions_that_hold(Holds::meshes) +
                               (which.with_imported ? ", and " + imported_extensions() : "");
    diagnostics.error({.file = folder.string()}, "no-scenes", "holds no scene, nor do the folders below it",
                      which.with_sprites ? meshes + "; sprites are images (" + extensions_that_hold(Holds::image) +
                                               ") and frame lists (" + extensions_that_hold(Holds::frame_list) + ')'
                      : has_images ? "its images count as sprites only if the pipeline has a stage or an evaluator for "
                                     "sprites, which it does not"
                                   : meshes);
    return std::nullopt;
  }
  std::ranges::sort(scenes);
  return scenes;
}

}  // namespace foredraw
