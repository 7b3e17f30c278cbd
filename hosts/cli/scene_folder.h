#pragma once
// Folders of scenes.

#include <foredraw/base/diagnostics.h>
#include <foredraw/pipeline/pipeline.h>
#include <foredraw/technique/registry.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace foredraw {

/// Which files of a folder count as scenes. Images lie beside models as their textures, so they are sprites only to who
/// works on sprites.
struct FolderScenes {
  bool with_sprites = false;   ///< frame lists, and images that no list in the folder names
  bool with_imported = false;  ///< files of other programs, such as FBX
};

/// Whether the pipeline has a stage or an evaluator for sprites: one whose card says that it acts on them.
bool works_on_sprites(const Pipeline& pipeline, const Registry& registry);
/// With what can be imported where there is an importer, which is looked for here: ask once, not for each file.
FolderScenes scenes_for(bool works_on_sprites);
inline FolderScenes scenes_for(const Pipeline& pipeline, const Registry& registry) {
  return scenes_for(works_on_sprites(pipeline, registry));
}

/// Whether a file of a folder counts as a scene that holds meshes. One that is imported does not where a .glb or .gltf
/// of its name lies beside it, which was made of it.
bool is_scene_of_folder(const std::filesystem::path& file, const FolderScenes& which);

/// The scenes in a folder and the folders below it: their paths from the folder on, sorted. Links to folders are not
/// followed, and `except` (a folder that may lie inside, where results go) is left out unless it is the folder itself.
/// nullopt, with an error, where a folder can not be read or there is no scene.
std::optional<std::vector<std::filesystem::path>> scenes_below(const std::filesystem::path& folder,
                                                               const std::filesystem::path& except,
                                                               const FolderScenes& which, Diagnostics& diagnostics);

}  // namespace foredraw
