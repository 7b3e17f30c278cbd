// A document to files: .glb, or .gltf with its .bin beside.
#include <foredraw/io/private/gltf_uri.h>
#include <foredraw/io/private/gltf_write.h>

#include <cstring>

namespace foredraw::gltf {

namespace {

namespace fs = std::filesystem;

std::string utf8(const fs::path& path) {
  const std::u8string text = path.generic_u8string();
  return {text.begin(), text.end()};
}

void put_word(std::vector<std::byte>& to, std::uint32_t value) {
  const std::size_t at = to.size();
  to.resize(at + 4);
  std::memcpy(to.data() + at, &value, 4);
}

void put_chunk(std::vector<std::byte>& to, std::uint32_t type, Bytes bytes, std::byte padding) {
  put_word(to, static_cast<std::uint32_t>((bytes.size() + 3) / 4 * 4));
  put_word(to, type);
  to.insert(to.end(), bytes.begin(), bytes.end());
  to.resize((to.size() + 3) / 4 * 4, padding);
}

std::vector<std::byte> glb(const std::string& text, const Written& written) {
  std::vector<std::byte> bytes;
  put_word(bytes, glb_magic);
  put_word(bytes, 2);
  put_word(bytes, 0);  // the length, known below
  put_chunk(bytes, glb_json_chunk, std::as_bytes(std::span(text)), std::byte{' '});
  if (!written.buffer.empty()) put_chunk(bytes, glb_bin_chunk, written.buffer, std::byte{0});
  for (const Chunk& chunk : written.further_chunks) put_chunk(bytes, chunk.type, chunk.bytes, std::byte{0});
  const auto length = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(bytes.data() + 8, &length, 4);
  return bytes;
}

/// What the document says of its one buffer.
void set_buffer(Json& json, std::size_t length, const std::string& uri) {
  if (length == 0) {
    json.erase("buffers");
    return;
  }
  Json buffer = json.contains("buffers") && !json["buffers"].empty() ? json["buffers"][0] : Json::object();
  buffer.erase("extensions");  // said how the old bytes were compressed
  buffer["byteLength"] = length;
  if (uri.empty()) {
    buffer.erase("uri");
  } else {
    buffer["uri"] = uri;
  }
  json["buffers"] = Json::array({std::move(buffer)});
}

}  // namespace

bool is_glb(const fs::path& target) {
  const std::string extension = target.extension().string();
  return extension == ".glb" || extension == ".GLB";
}

std::optional<std::vector<OutputFile>> packed(Written written, const fs::path& target, Diagnostics& diagnostics) {
  if (is_glb(target)) {
    set_buffer(written.json, written.buffer.size(), {});
    const std::string text = written.json.dump();
    if (text.size() + written.buffer.size() > std::size_t{4'000'000'000}) {
      diagnostics.error({.file = target.string()}, "too-large", "a .glb can not hold more than 4 GB",
                        "write a .gltf, whose bytes lie beside it");
      return std::nullopt;
    }
    return std::vector<OutputFile>{{target, glb(text, written)}};
  }
  fs::path beside = target;
  beside.replace_extension(".bin");
  set_buffer(written.json, written.buffer.size(), percent_encoded(utf8(beside.filename())));
  const std::string text = written.json.dump(2) + '\n';
  const Bytes bytes = std::as_bytes(std::span(text));
  std::vector<OutputFile> files{{target, {bytes.begin(), bytes.end()}}};
  if (!written.buffer.empty()) files.push_back({beside, std::move(written.buffer)});
  return files;
}

void relocate_images(Json& json, const Document& document, const fs::path& target, Diagnostics& diagnostics) {
  const auto images = json.find("images");
  if (images == json.end()) return;
  const fs::path to = fs::absolute(target).parent_path().lexically_normal();
  const fs::path from =
      document.folder.empty() ? fs::path() : (fs::absolute(document.folder) / "").lexically_normal().parent_path();
  for (Json& image : *images) {
    const auto uri = image.find("uri");
    if (uri == image.end() || !uri->is_string() || is_data_uri(uri->get<std::string>()) || from == to) continue;
    const auto path = percent_decoded(uri->get<std::string>());
    if (!path || path->empty() || path->front() == '/' || path->find(':') != std::string::npos) continue;
    if (from.empty()) {
      diagnostics.note({.file = document.name, .inside = "images"}, "image-outside",
                       "the images are files beside the glTF, whose folder is not known; their names stay as they are",
                       "copy '" + *path + "' beside the output");
      return;
    }
    const fs::path file = (from / fs::path(std::u8string(path->begin(), path->end()))).lexically_normal();
    *uri = percent_encoded(utf8(file.lexically_relative(to)));
  }
}

}  // namespace foredraw::gltf
