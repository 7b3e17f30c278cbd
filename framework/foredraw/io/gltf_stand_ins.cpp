// A .gltf and its buffers put in the place of others.
//
// Two renames are two moments. Between them a kill would leave the old .gltf beside the new buffer, of which it says
// something else. So the new buffers come first under names that nobody refers to yet, with a .gltf that names these;
// with that in place the buffers' own names are free to be taken, and then the .gltf's.
#include <foredraw/io/private/gltf_document.h>
#include <foredraw/io/private/gltf_stand_ins.h>
#include <foredraw/io/private/gltf_uri.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace foredraw::gltf {

namespace {

namespace fs = std::filesystem;

constexpr const char* mark = ".foredraw-";

std::optional<Json> text_of(const OutputFile& file) {
  const Bytes bytes = file.bytes;
  if (bytes.empty() || bytes.front() != std::byte{'{'}) return std::nullopt;
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  Json json = Json::parse(text, text + bytes.size(), nullptr, false);
  return json.is_object() && json.contains("buffers") ? std::optional(std::move(json)) : std::nullopt;
}

/// Whether the old .gltf may be reading something else from that name.
bool is_in_the_way(const OutputFile& file) {
  std::error_code error;
  if (!fs::is_regular_file(file.path, error)) return false;
  if (fs::file_size(file.path, error) != file.bytes.size() || error) return true;
  Diagnostics ignored;
  const auto there = read_file(file.path, ignored);
  return there != file.bytes;
}

std::string utf8_name(const OutputFile& file) {
  const std::u8string name = file.path.filename().u8string();
  return {name.begin(), name.end()};
}

fs::path stand_in_for(const OutputFile& file) {
  fs::path path = file.path;
  const std::string number = fmt::format("{:016x}", content_hash(std::span<const std::byte>(file.bytes)).low);
  path.replace_filename(file.path.stem().string() + mark + number + file.path.extension().string());
  return path;
}

}  // namespace

std::vector<OutputFile> stand_ins(std::span<const OutputFile> files) {
  std::error_code error;
  if (files.size() < 2 || !fs::is_regular_file(files.front().path, error)) return {};
  std::optional<Json> json = text_of(files.front());
  if (!json) return {};
  std::vector<OutputFile> result(1);
  bool found = false;
  std::vector<OutputFile> others(files.begin() + 1, files.end());
  for (Json& buffer : (*json)["buffers"]) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end() || is_data_uri(uri->get<std::string>())) continue;
    const std::string name = *percent_decoded(uri->get<std::string>());
    const auto named =
        std::find_if(files.begin() + 1, files.end(), [&](const OutputFile& file) { return utf8_name(file) == name; });
    if (named == files.end() || !is_in_the_way(*named)) continue;
    OutputFile& other = others[static_cast<std::size_t>(named - files.begin()) - 1];
    other.path = stand_in_for(*named);
    *uri = percent_encoded(utf8_name(other));
    found = true;
  }
  if (!found) return {};
  const std::string text = json->dump();
  const Bytes bytes = std::as_bytes(std::span(text));
  result.front() = {files.front().path, {bytes.begin(), bytes.end()}};
  std::move(others.begin(), others.end(), std::back_inserter(result));
  return result;
}

void remove_stand_ins(const OutputFile& file) {
  const std::string begins = file.path.stem().string() + mark;
  const std::string ends = file.path.extension().string();
  const fs::path folder = file.path.has_parent_path() ? file.path.parent_path() : fs::path(".");
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.size() != begins.size() + 16 + ends.size() || name.compare(0, begins.size(), begins) != 0) continue;
    if (name.find_first_not_of("0123456789abcdef", begins.size()) != begins.size() + 16) continue;
    if (name.compare(begins.size() + 16, ends.size(), ends) == 0) left.push_back(entry->path());
  }
  for (const fs::path& path : left) fs::remove(path, error);
}

}  // namespace foredraw::gltf
