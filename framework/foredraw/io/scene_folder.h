#pragma once
// Folders of scenes.

#include <foredraw/base/diagnostics.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace foredraw {

/// The files in a folder and the folders below it whose extension says that they hold a scene: their paths from the
/// folder on, sorted. Links to folders are not followed, and `except` (a folder that may lie inside, where results go)
/// is left out unless it is the folder itself. nullopt, with an error, where a folder can not be read or there is no
/// scene.
std::optional<std::vector<std::filesystem::path>> scenes_below(const std::filesystem::path& folder,
                                                               const std::filesystem::path& except,
                                                               Diagnostics& diagnostics);

}  // namespace foredraw
