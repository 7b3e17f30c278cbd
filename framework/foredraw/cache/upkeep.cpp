#include <foredraw/cache/upkeep.h>

#include <foredraw/cache/names.h>

#include <algorithm>
#include <functional>
#include <tuple>
#include <vector>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t an_hour = std::int64_t{3600} * 1'000'000'000;

struct CacheFile {
  fs::path path;
  FileFacts facts;
  bool is_entry = false;
};

/// Every file of the cache's own layout. Others may come and go meanwhile.
void each_file(const fs::path& folder, const std::function<void(CacheFile)>& visit) {
  for (const char* part : {"entries", "memory"}) {
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder / part, error), end; !error && at != end; at.increment(error)) {
      const bool is_known = stamp_called(at->path()) || is_begun_file(at->path());
      const auto facts = is_known ? file_facts(at->path()) : std::nullopt;
      if (facts) visit({at->path(), *facts, part == std::string_view("entries") && !is_begun_file(at->path())});
    }
  }
}

}  // namespace

CacheContents contents_of_cache(const fs::path& folder) {
  CacheContents contents;
  each_file(folder, [&](const CacheFile& file) {
    contents.bytes += file.facts.size;
    if (!file.is_entry) return;
    ++contents.entries;
    contents.oldest = contents.oldest == 0 ? file.facts.written : std::min(contents.oldest, file.facts.written);
  });
  return contents;
}

std::uint64_t trim_cache(const fs::path& folder, std::uint64_t bytes) {
  std::vector<CacheFile> files;
  std::uint64_t there = 0, gone = 0;
  std::error_code error;
  each_file(folder, [&](CacheFile file) {
    if (is_begun_file(file.path)) {
      if (file.facts.written < file_clock() - an_hour) fs::remove(file.path, error);
      return;
    }
    there += file.facts.size;
    files.push_back(std::move(file));
  });
  std::ranges::sort(files, [](const CacheFile& a, const CacheFile& b) {
    return std::tie(a.facts.written, a.path) < std::tie(b.facts.written, b.path);
  });
  for (const CacheFile& file : files) {
    if (there <= bytes) break;
    if (!fs::remove(file.path, error)) continue;
    there -= file.facts.size;
    gone += file.is_entry ? 1 : 0;
  }
  return gone;
}

std::uint64_t verify_cache(const fs::path& folder, const Cache& cache, Diagnostics& diagnostics) {
  std::vector<fs::path> damaged;
  each_file(folder, [&](const CacheFile& file) {
    if (!file.is_entry) return;
    Diagnostics ignored;
    const auto entry = cache.look_at(*stamp_called(file.path), ignored);
    bool is_sound = entry.has_value();
    for (std::size_t i = 0; is_sound && i < entry->size(); ++i) is_sound = entry->read(i).has_value();
    if (!is_sound) damaged.push_back(file.path);
  });
  std::error_code error;
  for (const fs::path& entry : damaged) {
    diagnostics.warning({.file = entry.string()}, "cache-entry-damaged", "this entry of the cache is damaged",
                        fs::remove(entry, error) ? "it was removed; what it held is made again when it is asked for"
                                                 : "it could not be removed: " + error.message());
  }
  return damaged.size();
}

}  // namespace foredraw
