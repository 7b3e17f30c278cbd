#pragma once
// Results kept by content, in a folder that any number of processes and machines share without locks. Two who write the
// same entry write the same; each entry comes beside its place and is renamed into it. What is read of an entry is held
// against its stamps, so that one that is torn or damaged counts as none.

#include <foredraw/base/diagnostics.h>
#include <foredraw/cache/file_hashes.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

class Cache {
 public:
  /// One that was found: what its owner wrote about it, which is whole, and its contents, which are read when they are
  /// asked for.
  class Entry {
   public:
    const std::string& about() const { return about_; }
    std::size_t size() const { return contents_.size(); }
    const HashedContent& stamp(std::size_t content) const { return contents_[content]; }
    /// Nothing where it is not what was written.
    std::optional<std::vector<std::byte>> read(std::size_t content) const;

   private:
    friend class Cache;
    std::filesystem::path place_;
    std::vector<std::byte> beginning_;  ///< of the file
    std::uint64_t offset_ = 0;          ///< of the first content
    std::string about_;
    std::vector<HashedContent> contents_;
  };

  /// Makes the folder, unless it is there. Nothing, with an error, where that can not be, or it holds other things.
  static std::optional<Cache> in(const std::filesystem::path& folder, Diagnostics& diagnostics);

  /// `damaged` is told of an entry that is there and can not be used.
  std::optional<Entry> find(const Stamp& key, Diagnostics& damaged) const;
  /// The same, and when it was used last stays as it is.
  std::optional<Entry> look_at(const Stamp& key, Diagnostics& damaged) const;
  /// Why it could not be kept; empty: it is.
  std::string keep(const Stamp& key, std::string_view about,
                   std::span<const std::span<const std::byte>> contents) const;

  const FileHashes& hashes() const { return hashes_; }
  std::filesystem::path place_of(const Stamp& key) const;

 private:
  explicit Cache(const std::filesystem::path& folder);

  std::filesystem::path entries_;
  FileHashes hashes_;
};

/// "foredraw-cache": a file of that name says that a folder is one.
extern const char* const name_of_cache_file;

/// What a user is told of an entry that is no good.
void tell_damaged(const std::filesystem::path& entry, Diagnostics& diagnostics);

}  // namespace foredraw
