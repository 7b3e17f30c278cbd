#pragma once
// Which files a piece of work has read: what it made is out of date once one of them is another.

#include <foredraw/base/content_hash.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <mutex>
#include <span>
#include <vector>

namespace foredraw {

struct FileRead {
  enum class Found {
    content,  ///< it was read
    there,    ///< it was only looked for
    missing,
  };
  static constexpr std::uint64_t all_of_it = std::numeric_limits<std::uint64_t>::max();

  std::filesystem::path path;  ///< as it was opened
  Found found = Found::content;
  std::uint64_t at_most = all_of_it;  ///< so many bytes were asked for, from its beginning on
  std::uint64_t bytes = 0;            ///< so many there were
  Stamp stamp;                        ///< of these
};

/// Gathers them, from any threads. What is told is what was read, not what the file holds afterwards.
class FilesRead {
 public:
  void read(const std::filesystem::path& path, std::uint64_t at_most, std::span<const std::byte> bytes);
  void there(const std::filesystem::path& path);
  void missing(const std::filesystem::path& path);

  /// Each once, sorted by path. What was read was not only looked for. A file of which two reads saw different things
  /// stands there twice.
  std::vector<FileRead> all() const;

 private:
  void add(FileRead file);

  mutable std::mutex mutex_;
  std::vector<FileRead> files_;
};

}  // namespace foredraw
