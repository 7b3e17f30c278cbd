#include <foredraw/cache/file_hashes.h>

#include <foredraw/cache/names.h>
#include <foredraw/platform/files.h>

#include <cstdio>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t worth_remembering = std::uint64_t{1}
                                            << 18;  ///< reading less takes no longer than looking it up
constexpr std::int64_t tick = 2'000'000'000;        ///< of the coarsest clock that file systems have

/// The facts and the stamp on one line, and a stamp of that: a line that is cut off is none.
std::string line_of(const FileFacts& facts, const Stamp& stamp) {
  char text[256];
  const int length = std::snprintf(
      text, sizeof text, "%llu %llu %llu %lld %lld %s\n", static_cast<unsigned long long>(facts.size),
      static_cast<unsigned long long>(facts.inode), static_cast<unsigned long long>(facts.device),
      static_cast<long long>(facts.written), static_cast<long long>(facts.changed), to_text(stamp).c_str());
  return {text, static_cast<std::size_t>(length)};
}

}  // namespace

bool tell_changes(const FileFacts& facts, std::int64_t now) {
  return std::max(facts.written, facts.changed) < now - tick;
}

std::optional<HashedContent> FileHashes::remembered(const fs::path& note, const FileFacts& facts) const {
  Diagnostics ignored;
  const auto bytes = read_file(note, ignored);
  if (!bytes) return std::nullopt;
  const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  constexpr std::size_t digits = 32;
  if (text.size() <= digits + 1) return std::nullopt;
  const auto stamp = stamp_in(std::string_view(text).substr(text.size() - digits - 1, digits));
  if (!stamp || text != line_of(facts, *stamp)) return std::nullopt;
  return HashedContent{*stamp, facts.size};
}

std::optional<HashedContent> FileHashes::of(const fs::path& file, std::uint64_t at_most) const {
  const auto facts = file_facts(file);
  if (!facts) return std::nullopt;
  const bool is_whole = facts->size <= at_most;
  if (memory_.empty() || !is_whole || facts->size < worth_remembering) return hashed_content(file, at_most);
  std::error_code error;
  const fs::path note = place_below(memory_, content_hash(std::span(fs::absolute(file, error).native())));
  if (auto known = remembered(note, *facts)) return known;
  const auto content = hashed_content(file, at_most);
  if (!content || content->bytes != facts->size || file_facts(file) != facts || !tell_changes(*facts, clock_())) {
    return content;
  }
  fs::create_directories(note.parent_path(), error);
  const std::string line = line_of(*facts, content->stamp);
  const std::span<const std::byte> piece = std::as_bytes(std::span(line));
  place_file(note, std::span(&piece, 1));  // where that can not be, it is read again
  return content;
}

}  // namespace foredraw
