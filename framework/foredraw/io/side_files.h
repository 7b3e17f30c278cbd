#pragma once
// Files of a scene's products for engines, beside the scene or instead of it.

#include <foredraw/base/diagnostics.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/product_row.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace foredraw {

/// The kind of side file that a row offers for the path's extension; nothing where it offers none.
std::optional<SideFileKind> side_file_kind(const ProductRow& row, const std::filesystem::path& path);

/// The paths that encode_side_file() writes to, that itself first.
std::vector<std::filesystem::path> paths_of_side_file(const ProductRow& row, const std::filesystem::path& path);

/// The file that a scene's product is written as, by the extension, and what comes beside it. nullopt, with an error,
/// where the scene has no such product or it can not be said.
std::optional<std::vector<OutputFile>> encode_side_file(const Scene& scene, const ProductRow& row,
                                                        const std::filesystem::path& path, Diagnostics& diagnostics);

}  // namespace foredraw
