// A document to files: .glb, or .gltf with its .bin beside.
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/text/private/file_kind.h>
#include <foredraw/io/text/private/uri.h>

#include <cstring>
#include <limits>
#include <utility>

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
  bytes.reserve(text.size() + written.laid_out.bytes.size() + 64);
  put_word(bytes, glb_magic);
  put_word(bytes, 2);
  put_word(bytes, 0);  // the length, known below
  put_chunk(bytes, glb_json_chunk, std::as_bytes(std::span(text)), std::byte{' '});
  if (!written.laid_out.bytes.empty()) put_chunk(bytes, glb_bin_chunk, written.laid_out.bytes, std::byte{0});
  for (const Chunk& chunk : written.further_chunks) put_chunk(bytes, chunk.type, chunk.bytes, std::byte{0});
  const auto length = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(bytes.data() + 8, &length, 4);
  return bytes;
}

void describe(Json& buffer, std::size_t length, const std::string& uri) {
  buffer["byteLength"] = length;
  if (uri.empty()) {
    buffer.erase("uri");
  } else {
    buffer["uri"] = uri;
  }
}

/// What the document says of its buffers. `uri`: of the first one.
void set_buffers(Written& written, const fs::path& target, const std::string& uri) {
  Json& json = written.json;
  const LaidOut& laid_out = written.laid_out;
  if (laid_out.bytes.empty()) {
    json.erase("buffers");
    return;
  }
  describe(json["buffers"][0], laid_out.bytes.size(), uri);
  for (std::size_t i = 0; i < laid_out.fallbacks.size(); ++i) {
    Json buffer = laid_out.fallbacks[i].json;
    const std::string beside = percent_encoded(utf8(fallback_beside(target, i).filename()));
    describe(buffer, laid_out.fallbacks[i].length, laid_out.fallbacks[i].there ? beside : std::string());
    json["buffers"].push_back(std::move(buffer));
  }
}

void add_fallbacks(std::vector<OutputFile>& files, LaidOut& laid_out, const fs::path& target) {
  for (std::size_t i = 0; i < laid_out.fallbacks.size(); ++i) {
    if (!laid_out.fallbacks[i].there) continue;
    files.push_back({fallback_beside(target, i), std::move(laid_out.fallbacks[i].bytes)});
  }
}

}  // namespace

bool is_glb(const fs::path& target) { return lower_extension(target) == ".glb"; }

fs::path buffer_beside(const fs::path& target) {
  fs::path beside = target;
  return beside.replace_extension(".bin");
}

fs::path fallback_beside(const fs::path& target, std::size_t i) {
  fs::path beside = target;
  if (!is_glb(target)) beside.replace_extension();
  return beside += i == 0 ? ".fallback.bin" : ".fallback" + std::to_string(i) + ".bin";
}

std::optional<std::vector<OutputFile>> packed(Written written, const fs::path& target, Diagnostics& diagnostics) {
  if (is_glb(target)) {
    set_buffers(written, target, {});
    const std::string text = std::exchange(written.json, {}).dump();
    std::size_t length = text.size() + written.laid_out.bytes.size() + 64;
    for (const Chunk& chunk : written.further_chunks) length += chunk.bytes.size() + 16;
    if (length > std::numeric_limits<std::uint32_t>::max()) {
      diagnostics.error({.file = target.string()}, "too-large", "a .glb cannot hold more than 4 GB",
                        "write a .gltf, whose bytes are in a .bin beside it");
      return std::nullopt;
    }
    std::vector<OutputFile> files{{target, glb(text, written)}};
    add_fallbacks(files, written.laid_out, target);
    return files;
  }
  const fs::path beside = buffer_beside(target);
  set_buffers(written, target, percent_encoded(utf8(beside.filename())));
  const std::string text = written.json.dump(written.compact ? -1 : 2) + (written.compact ? "" : "\n");
  const Bytes bytes = std::as_bytes(std::span(text));
  std::vector<OutputFile> files{{target, {bytes.begin(), bytes.end()}}};
  if (!written.laid_out.bytes.empty()) files.push_back({beside, std::move(written.laid_out.bytes)});
  add_fallbacks(files, written.laid_out, target);
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
      diagnostics.note(
          {.file = document.name, .inside = "images"}, "image-outside",
          "the images are separate files, but the folder of the glTF is unknown; their names are unchanged",
          "copy '" + *path + "' beside the output");
      return;
    }
    const fs::path file = (from / fs::path(std::u8string(path->begin(), path->end()))).lexically_normal();
    *uri = percent_encoded(utf8(file.lexically_relative(to)));
  }
}

}  // namespace foredraw::gltf
