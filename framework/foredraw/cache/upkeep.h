#pragma once
// Looking after a cache: how much it holds, whether it is sound, and what to throw away.

#include <foredraw/base/diagnostics.h>
#include <foredraw/cache/cache.h>

#include <cstdint>
#include <filesystem>

namespace foredraw {

struct CacheContents {
  std::uint64_t entries = 0;
  std::uint64_t bytes = 0;  ///< of all files of the cache
  std::int64_t oldest = 0;  ///< nanoseconds since 1970: when the entry that nobody used for longest was used last
};

CacheContents contents_of_cache(const std::filesystem::path& folder);

/// Removes what nobody used for longest, until no more than `bytes` are left, and what processes that were killed had
/// begun more than an hour ago. What else lies in the folder stays. The number of entries that are gone.
std::uint64_t trim_cache(const std::filesystem::path& folder, std::uint64_t bytes);

/// Reads every entry whole, tells of each that is damaged, and removes it. How many were.
std::uint64_t verify_cache(const std::filesystem::path& folder, const Cache& cache, Diagnostics& diagnostics);

}  // namespace foredraw
