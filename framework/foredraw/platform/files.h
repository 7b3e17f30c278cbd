#pragma once
// Files read whole, and written so that nothing is ever half there. Paths are UTF-8.

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/files_read.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw {

/// The whole file, or its first `at_most` bytes. nullopt, with a diagnostic that says why, where it can not be read.
/// `files` is told of it, unless it is null.
std::optional<std::vector<std::byte>> read_file(const std::filesystem::path& path, Diagnostics& diagnostics,
                                                std::size_t at_most = std::numeric_limits<std::size_t>::max(),
                                                FilesRead* files = nullptr);

/// All of standard input.
std::optional<std::vector<std::byte>> read_standard_input(Diagnostics& diagnostics);

bool write_standard_output(std::span<const std::byte> bytes, Diagnostics& diagnostics);

struct OutputFile {
  using Put = std::function<void(std::string_view)>;

  std::filesystem::path path;
  std::vector<std::byte> bytes;
  /// Puts what comes behind the bytes, piece by piece, while the file is written: what is long need not stand in
  /// memory.
  std::function<void(const Put&)> rest = nullptr;
};

/// Writes every file beside its place ("out.glb.foredraw-part0"), then renames them into it one after the other, the
/// first file last: it is the one that names the others. Where one can not be written, none is changed, and what was
/// begun is removed. A process that is killed meanwhile leaves every file old or new, never in between; what it had
/// begun is removed by the next who writes to the same place. Links are followed. A file that holds these bytes already
/// is not touched: it keeps its time and its inode, so that nobody who watches it takes it for a new one.
bool write_files(std::span<const OutputFile> files, Diagnostics& diagnostics);

}  // namespace foredraw
