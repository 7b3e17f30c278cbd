#pragma once
#include <cstdint>
#include <filesystem>

namespace foredraw::import {

/// Imports in a watched child of this process, for `parent`, into the block that it handed over. Without a file: the
/// stamp of this program and its libraries, in place of a GLB.
int serve_import(const std::filesystem::path& file, const std::filesystem::path& root, int parent,
                 std::uint64_t memory);

}  // namespace foredraw::import
