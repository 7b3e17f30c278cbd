// A .gltf and its buffers put in the place of others.
//
// Two renames are two moments. Between them a kill would leave the old .gltf beside the new buffer, of which it says
// something else. So the new buffers come first under names that nobody refers to yet, with a .gltf that names these;
// with that in place the buffers' own names are free to be taken, and then the .gltf's.
#include <foredraw/io/gltf/patch/private/stand_ins.h>
#include <foredraw/io/gltf/private/document.h>
#include <foredraw/io/text/private/uri.h>

#include <algorithm>
#include <iterator>

namespace foredraw::gltf {

namespace {

namespace fs = std::filesystem;

std::optional<Json> text_of(const OutputFile& file) {
  const Bytes bytes = file.bytes;
  if (bytes.empty() || bytes.front() != std::byte{'{'}) return std::nullopt;
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  Json json = Json::parse(text, text + bytes.size(), nullptr, false);
  return json.is_object() && json.contains("buffers") ? std::optional(std::move(json)) : std::nullopt;
}

/// Whether the old .gltf may be reading something else from that name.
bool is_in_the_way(const fs::path& path, const std::vector<std::byte>& bytes) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  if (fs::file_size(path, error) != bytes.size() || error) return true;
  Diagnostics ignored;
  return read_file(path, ignored) != bytes;
}

std::string utf8_name(const OutputFile& file) {
  const std::u8string name = file.path.filename().u8string();
  return {name.begin(), name.end()};
}

/// "out.foredraw-0.bin", "out.foredraw-1.bin", ...
fs::path stand_in(const fs::path& place, std::size_t number) {
  return place.parent_path() / (place.stem() += ".foredraw-" + std::to_string(number) + place.extension().string());
}

/// The first that is free. Those of runs that were killed are not: the .gltf that is there may name one.
fs::path free_stand_in(const OutputFile& file) {
  std::size_t number = 0;
  while (is_in_the_way(stand_in(file.path, number), file.bytes)) ++number;
  return stand_in(file.path, number);
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
    if (named == files.end() || !is_in_the_way(named->path, named->bytes)) continue;
    OutputFile& other = others[static_cast<std::size_t>(named - files.begin()) - 1];
    other.path = free_stand_in(*named);
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

/// The last first, so that the numbers stay without gaps, whenever the end comes.
void remove_stand_ins(const OutputFile& file) {
  std::error_code error;
  std::size_t count = 0;
  while (fs::exists(stand_in(file.path, count), error)) ++count;
  while (count > 0) fs::remove(stand_in(file.path, --count), error);
}

}  // namespace foredraw::gltf
