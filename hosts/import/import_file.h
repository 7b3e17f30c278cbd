#pragma once
#include "told.h"

#include <filesystem>
#include <string>

namespace foredraw::import {

/// Reads a scene with Assimp, and gives it as a GLB. Polygons become triangles; nothing else is changed, joined or
/// reordered. Files that it names are read below its folder, or below `root` if there is one. Throws std::exception,
/// whose words say why, where there is no such scene.
std::string import_file(const std::filesystem::path& file, const std::filesystem::path& root, Told& told);

}  // namespace foredraw::import
