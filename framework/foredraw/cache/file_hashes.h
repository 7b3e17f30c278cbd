#pragma once
// The stamps of files' content, remembered by what the system tells of the files: a large one that did not change is
// not read again.

#include <foredraw/platform/file_facts.h>

#include <filesystem>
#include <optional>

namespace foredraw {

/// Whether facts that were seen at `now` will differ after any later change. Not where the file was changed just
/// before: clocks of file systems tick, and what is changed twice within a tick looks as if it had been changed once.
/// Nor where it was changed in the future, because a clock was set.
bool tell_changes(const FileFacts& facts, std::int64_t now);

class FileHashes {
 public:
  /// `memory`: the folder where they are remembered; empty: they are not. `clock`: that of the files' times.
  explicit FileHashes(std::filesystem::path memory = {}, std::int64_t (*clock)() = file_clock)
      : memory_(std::move(memory)), clock_(clock) {}

  /// Of the file's first `at_most` bytes, or all where it has fewer. Nothing where it can not be read.
  std::optional<HashedContent> of(const std::filesystem::path& file, std::uint64_t at_most) const;

 private:
  std::optional<HashedContent> remembered(const std::filesystem::path& note, const FileFacts& facts) const;

  std::filesystem::path memory_;
  std::int64_t (*clock_)();
};

}  // namespace foredraw
