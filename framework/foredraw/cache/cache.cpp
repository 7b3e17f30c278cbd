#include <foredraw/cache/cache.h>

#include <foredraw/cache/names.h>
#include <foredraw/platform/files.h>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view form = "foredraw-cache-entry-1";
constexpr std::size_t read_at_first = std::size_t{1} << 16;  ///< in which most entries are whole
constexpr std::int64_t used_lately = std::int64_t{3600} * 1'000'000'000;

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// "FORM LENGTH STAMP\n" of the head that follows: of these many bytes, with this stamp.
std::string first_line(std::string_view head) {
  return std::string(form) + ' ' + std::to_string(head.size()) + ' ' + to_text(content_hash(bytes_of(head))) + '\n';
}

/// "KEY CONTENTS\n", a line "BYTES STAMP\n" for each content, and what the owner says.
std::string head_of(const Stamp& key, std::string_view about, std::span<const std::span<const std::byte>> contents) {
  std::string head = to_text(key) + ' ' + std::to_string(contents.size()) + '\n';
  for (const auto content : contents) {
    head += std::to_string(content.size()) + ' ' + to_text(content_hash(content)) + '\n';
  }
  return head.append(about);
}

}  // namespace

const char* const name_of_cache_file = "foredraw-cache";

void tell_damaged(const fs::path& entry, Diagnostics& diagnostics) {
  diagnostics.warning({.file = entry.string()}, "cache-entry-damaged",
                      "this entry of the cache is damaged; what it held is made anew",
                      "foredraw cache FOLDER --verify finds all that are");
}

Cache::Cache(const fs::path& folder) : entries_(folder / "entries"), hashes_(folder / "memory") {}

std::optional<Cache> Cache::in(const fs::path& folder, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    diagnostics.error({.file = folder.string()}, "cannot-use-cache", why, hint);
    return std::nullopt;
  };
  std::error_code error;
  if (fs::is_regular_file(folder / name_of_cache_file, error)) return Cache(folder);
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    return refuse("is a file; a folder was expected", "name another folder; it is made if it is not there");
  }
  fs::create_directories(folder, error);
  if (error) return refuse("cannot be created: " + error.message(), "choose a folder that you may write to");
  bool holds_other_things = false;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    // Another process may begin the cache just now.
    holds_other_things = holds_other_things || !at->path().filename().native().starts_with(name_of_cache_file);
  }
  if (holds_other_things && !fs::is_regular_file(folder / name_of_cache_file, error)) {
    return refuse("is no cache, and holds other things", "name an empty folder, or one that is not there");
  }
  constexpr std::string_view text = "A cache of results of foredraw. It may be deleted at any time.\n";
  const std::span<const std::byte> piece = bytes_of(text);
  if (const std::string why = place_file(folder / name_of_cache_file, std::span(&piece, 1)); !why.empty()) {
    return refuse("cannot be written to: " + why, "choose a folder that you may write to");
  }
  return Cache(folder);
}

fs::path Cache::place_of(const Stamp& key) const { return place_below(entries_, key); }

std::optional<Cache::Entry> Cache::find(const Stamp& key, Diagnostics& damaged) const {
  auto entry = look_at(key, damaged);
  const auto facts = entry ? file_facts(entry->place_) : std::nullopt;
  if (facts && facts->written < file_clock() - used_lately) mark_as_used(entry->place_);
  return entry;
}

std::optional<Cache::Entry> Cache::look_at(const Stamp& key, Diagnostics& damaged) const {
  Entry entry;
  entry.place_ = place_of(key);
  const auto facts = file_facts(entry.place_);
  Diagnostics ignored;
  auto beginning = facts ? read_file(entry.place_, ignored, read_at_first) : std::nullopt;
  if (!beginning) return std::nullopt;
  entry.beginning_ = std::move(*beginning);
  const auto no_good = [&]() -> std::optional<Entry> {
    tell_damaged(entry.place_, damaged);
    return std::nullopt;
  };
  const std::string_view text = text_of(entry.beginning_);
  const std::size_t line = text.find('\n');
  std::istringstream words{std::string(text.substr(0, std::min(line, text.size())))};
  std::string what, stamp;
  std::uint64_t length = 0;
  if (line == std::string_view::npos || !(words >> what >> length >> stamp) || what != form) return no_good();
  const auto head_bytes = read_piece(entry.place_, line + 1, std::min(length, facts->size));
  if (!head_bytes || head_bytes->size() != length || to_text(content_hash(*head_bytes)) != stamp) return no_good();
  std::istringstream head{std::string(text_of(*head_bytes))};
  std::size_t count = 0;
  if (!(head >> what >> count) || what != to_text(key)) return no_good();
  std::uint64_t rest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    HashedContent content;
    if (!(head >> content.bytes >> stamp) || !stamp_in(stamp)) return no_good();
    content.stamp = *stamp_in(stamp);
    rest += content.bytes;
    entry.contents_.push_back(content);
  }
  head.get();  // the line's end
  entry.about_ = text_of(*head_bytes).substr(static_cast<std::size_t>(head.tellg()));
  entry.offset_ = line + 1 + length;
  if (facts->size != entry.offset_ + rest) return no_good();
  return entry;
}

std::optional<std::vector<std::byte>> Cache::Entry::read(std::size_t content) const {
  std::uint64_t offset = offset_;
  for (std::size_t i = 0; i < content; ++i) offset += contents_[i].bytes;
  const HashedContent& wanted = contents_[content];
  std::optional<std::vector<std::byte>> bytes;
  if (offset + wanted.bytes <= beginning_.size()) {
    const auto part = std::span(beginning_).subspan(offset, wanted.bytes);
    bytes.emplace(part.begin(), part.end());
  } else {
    bytes = read_piece(place_, offset, wanted.bytes);
  }
  return bytes && content_hash(*bytes) == wanted.stamp ? std::move(bytes) : std::nullopt;
}

std::string Cache::keep(const Stamp& key, std::string_view about,
                        std::span<const std::span<const std::byte>> contents) const {
  const std::string head = head_of(key, about, contents);
  const std::string line = first_line(head);
  std::vector<std::span<const std::byte>> pieces{bytes_of(line), bytes_of(head)};
  pieces.insert(pieces.end(), contents.begin(), contents.end());
  const fs::path place = place_of(key);
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  return error ? error.message() : place_file(place, pieces);
}

}  // namespace foredraw
