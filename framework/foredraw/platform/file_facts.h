#pragma once
// What a system tells of a file without reading it, and parts of files.

#include <foredraw/base/content_hash.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// Times are nanoseconds since 1970.
struct FileFacts {
  std::uint64_t size = 0;
  std::uint64_t inode = 0;
  std::uint64_t device = 0;
  std::int64_t written = 0;  ///< when its content was
  std::int64_t changed = 0;  ///< when anything of it was, its name and times too: nobody can set this one back
  friend bool operator==(const FileFacts&, const FileFacts&) = default;
};

/// Of a regular file, links followed; nothing where there is none.
std::optional<FileFacts> file_facts(const std::filesystem::path& path);

/// True if a program has the file open to write to it. Nothing where this system does not tell, as of the files of
/// others.
std::optional<bool> is_open_for_writing(const std::filesystem::path& path);

/// By the clock that files' times are of.
std::int64_t file_clock();

/// Says that the file was used now. Where that can not be written, nothing happens.
void mark_as_used(const std::filesystem::path& path);

struct HashedContent {
  Stamp stamp;  ///< as content_hash() has it
  std::uint64_t bytes = 0;
};

/// Of the whole file, or its first `at_most` bytes, which never stand in memory all at once. Nothing where it can not
/// be read.
std::optional<HashedContent> hashed_content(const std::filesystem::path& path, std::uint64_t at_most);

/// So many bytes from `offset` on. Nothing where there are not so many, or they can not be read.
std::optional<std::vector<std::byte>> read_piece(const std::filesystem::path& path, std::uint64_t offset,
                                                 std::uint64_t length);

/// Writes the pieces beside the path ("name.part-..."), then renames. Does not wait for the disk as write_files() does:
/// for what is checked when it is read, and made again where it is damaged. Why it could not; empty: it is there.
std::string place_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> pieces);

/// Whether the name is one of those that place_file() gives to what it has begun.
bool is_begun_file(const std::filesystem::path& path);

}  // namespace foredraw
