#include <foredraw/cache/results.h>

#include <foredraw/cache/names.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace foredraw {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_lists = 16;  ///< for one input: as many states of the files beside it are remembered
constexpr const char* own = "own";

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

Stamp stamp_of(std::string_view text) { return content_hash(std::as_bytes(std::span(text))); }

/// Results whose place counts have lists of their own: two equal files are worked on at once, and neither may lose the
/// other's line.
Stamp key_of_lists(const Work& work, const Stamp& input, bool depends_on_place) {
  const Stamp place = depends_on_place ? stamp_of("place " + work.place) : stamp_of("anywhere");
  return combine(std::vector<Stamp>{work.how, input, place});
}

/// Where nothing else was read or looked for, the content of the file decides, and there is no list.
Stamp key_of_alone(const Stamp& lists) { return combine(std::vector<Stamp>{lists, stamp_of("alone")}); }

/// JSON holds UTF-8 alone: other names stand in it as bytes.
Json json_of(const fs::path& path) {
  const std::string& text = path.native();
  try {
    static_cast<void>(Json(text).dump());
    return text;
  } catch (const Json::exception&) {
    return std::vector<unsigned char>(text.begin(), text.end());
  }
}

fs::path path_in(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  std::string text;
  for (const Json& byte : json) text += static_cast<char>(byte.get<unsigned char>());
  return text;
}

Json json_of(const FileRead& file, bool is_own, const fs::path& folder) {
  Json json{{"from", is_own ? own : "lent"},
            {"path", json_of(is_own ? file.path.lexically_relative(folder) : file.path)}};
  if (file.found == FileRead::Found::missing) json["missing"] = true;
  if (file.found != FileRead::Found::content) return json;
  json["at-most"] = file.at_most;
  json["bytes"] = file.bytes;
  json["stamp"] = to_text(file.stamp);
  return json;
}

/// Whether the file is still what the list says.
bool still_holds(const Json& json, const fs::path& path, const FileHashes& hashes) {
  std::error_code error;
  if (json.value("missing", false)) return !fs::is_regular_file(path, error);
  if (!json.contains("stamp")) return fs::is_regular_file(path, error);
  const auto content = hashes.of(path, json.at("at-most").get<std::uint64_t>());
  return content && content->bytes == json.at("bytes").get<std::uint64_t>() &&
         to_text(content->stamp) == json.at("stamp").get<std::string>();
}

fs::path path_of(const Json& json, const fs::path& folder) {
  const fs::path path = path_in(json.at("path"));
  return json.at("from").get<std::string>() == own ? folder / path : path;
}

/// Whether two reads of one file saw the same.
bool agree(const std::vector<FileRead>& files) {
  for (std::size_t i = 1; i < files.size(); ++i) {
    const FileRead &a = files[i - 1], &b = files[i];
    if (a.path.native() != b.path.native()) continue;
    if (a.found != b.found || a.at_most == b.at_most) return false;
  }
  return true;
}

}  // namespace

namespace {

std::optional<FoundResult> found_by(const Stamp& key, const Cache& cache, const Work& work, Diagnostics& damaged) {
  if (auto entry = cache.find(key_of_alone(key), damaged)) {
    return FoundResult{key_of_alone(key), std::move(*entry), {work.input}, {}};
  }
  const auto lists = cache.find(key, damaged);
  if (!lists) return std::nullopt;
  const fs::path folder = folder_of(work.input);
  try {
    for (const Json& list : Json::parse(lists->about())) {
      const bool holds = std::ranges::all_of(
          list.at("read"), [&](const Json& file) { return still_holds(file, path_of(file, folder), cache.hashes()); });
      if (!holds) continue;
      const Stamp entry_key = stamp_in(list.at("entry").get<std::string>()).value_or(Stamp{});
      auto entry = cache.find(entry_key, damaged);
      if (!entry) return std::nullopt;
      FoundResult found{entry_key, std::move(*entry), {work.input}, {}};
      for (const Json& file : list.at("read")) {
        (file.contains("stamp") ? found.read : found.sought).push_back(path_of(file, folder));
      }
      return found;
    }
  } catch (const Json::exception&) {
    tell_damaged(cache.place_of(key), damaged);
  }
  return std::nullopt;
}

}  // namespace

std::optional<FoundResult> find_result(const Cache& cache, const Work& work, Diagnostics& damaged) {
  const auto input = cache.hashes().of(work.input, FileRead::all_of_it);
  if (!input) return std::nullopt;
  auto found = found_by(key_of_lists(work, input->stamp, false), cache, work, damaged);
  return found ? std::move(found) : found_by(key_of_lists(work, input->stamp, true), cache, work, damaged);
}

std::string keep_result(const Cache& cache, const Work& work, const WorkRead& read, bool depends_on_place,
                        std::string_view about, std::span<const std::span<const std::byte>> contents) {
  if (!agree(read.own) || !agree(read.lent)) return {};
  const fs::path folder = folder_of(work.input);
  std::optional<Stamp> input;
  Json list{{"read", Json::array()}};
  for (const FileRead& file : read.own) {
    if (file.path == work.input && file.found == FileRead::Found::content) {
      input = file.stamp;
    } else {
      list["read"].push_back(json_of(file, true, folder));
    }
  }
  if (!input) return {};
  for (const FileRead& file : read.lent) list["read"].push_back(json_of(file, false, folder));
  const Stamp key = key_of_lists(work, *input, depends_on_place);
  if (list["read"].empty()) return cache.keep(key_of_alone(key), about, contents);
  const Stamp entry = combine(std::vector<Stamp>{key, stamp_of(list.dump())});
  if (std::string why = cache.keep(entry, about, contents); !why.empty()) return why;

  list["entry"] = to_text(entry);
  Json lists = Json::array({list});
  Diagnostics ignored;
  const auto before = cache.find(key, ignored);
  const Json old = before ? Json::parse(before->about(), nullptr, false) : Json();
  for (const Json& other : old.is_array() ? old : Json::array()) {
    if (other != list && lists.size() < most_lists) lists.push_back(other);
  }
  return cache.keep(key, lists.dump(), {});
}

}  // namespace foredraw
