// Checks of buffers, buffer views and images: where the bytes come from, and that there are as many as claimed.
#include <foredraw/io/gltf/private/gate.h>
#include <foredraw/io/text/private/uri.h>
#include <foredraw/platform/files.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

namespace fs = std::filesystem;

/// The buffers that were read from files, by where these lie: a thousand may name the same.
using FileBuffers = std::map<fs::path, Bytes>;

/// The first `length` bytes of a file; what may follow is not read.
std::optional<Bytes> file_beside(Gate& gate, const std::string& uri, std::uint64_t length, const std::string& place,
                                 FileBuffers& files) {
  const fs::path& folder = gate.document().folder;
  const auto path = percent_decoded(uri);
  const std::string why = path ? why_not_beside(*path) : "is not well-formed";
  if (!why.empty()) {
    gate.error(place, "buffer-uri", fmt::format("'{}' {}; expected a file in the folder of the glTF", uri, why),
               "put the file beside the glTF and name it by a relative path, or pack both into a .glb");
    return std::nullopt;
  }
  if (folder.empty()) {
    gate.error(place, "buffer-missing",
               fmt::format("'{}' cannot be found, because the glTF was not read from a folder", uri),
               "give the path of the .gltf, or pack both into a .glb");
    return std::nullopt;
  }
  const fs::path file = folder / fs::path(std::u8string(path->begin(), path->end()));
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    gate.error(place, "buffer-missing", fmt::format("there is no file '{}' in the folder of the glTF", *path),
               "copy it there, or export as .glb, which holds everything");
    return std::nullopt;
  }
  if (!lies_within(file, folder)) {
    gate.error(place, "buffer-uri", fmt::format("'{}' is a link that leads out of the folder of the glTF", uri),
               "copy the file into the folder");
    return std::nullopt;
  }
  const std::uint64_t size = fs::file_size(file, error);
  if (error || size < length) {
    gate.error(place, "buffer-too-short",
               fmt::format("the file '{}' has {} bytes, but byteLength is {}", *path, error ? 0 : size, length));
    return std::nullopt;
  }
  Bytes& known = files[fs::canonical(file, error)];
  if (known.size() >= length) return known.first(length);
  Diagnostics reading;
  // Twice what was read before: so that growing lengths do not have the file read again and again.
  auto bytes =
      read_file(file, reading, std::max<std::uint64_t>(length, std::min<std::uint64_t>(size, 2 * known.size())));
  if (!bytes || bytes->size() < length) {
    gate.error(place, "buffer-missing",
               bytes ? "the file became shorter while it was read" : reading.all().front().message);
    return std::nullopt;
  }
  gate.document().kept.push_back(std::move(*bytes));
  known = gate.document().kept.back();
  return known.first(length);
}

/// Whether the buffer is but a plain copy of compressed views, which a reader that decompresses can do without.
bool is_fallback(Gate& gate, const Json& buffer, const std::string& place) {
  for (const char* name : meshopt_extensions) {
    const Json* extension = extension_of(buffer, name);
    if (extension == nullptr || !extension->is_object()) continue;
    if (gate.boolean(*extension, "fallback", in(in(place, "extensions"), name)).value_or(false)) return true;
  }
  return false;
}

bool may_be_beside(const Gate& gate, const std::string& uri) {
  const auto path = percent_decoded(uri);
  if (!path || !why_not_beside(*path).empty()) return true;  // told of by whoever looks for it
  std::error_code error;
  const fs::path& folder = gate.document().folder;
  return !folder.empty() && fs::exists(folder / fs::path(std::u8string(path->begin(), path->end())), error);
}

std::optional<Buffer> buffer_of(Gate& gate, std::size_t i, const Json& json, std::optional<Bytes> bin,
                                FileBuffers& files) {
  const std::string place = at("buffers", i);
  gate.required(json, "byteLength", place);
  const auto length = gate.whole(json, "byteLength", place, 1);
  const auto uri = gate.text(json, "uri", place);
  const bool fallback = is_fallback(gate, json, place);
  if (!length) return std::nullopt;
  if (!uri && json.contains("uri")) return std::nullopt;
  const Buffer absent{{}, static_cast<std::size_t>(*length), fallback};

  if (!uri) {
    if (i == 0 && bin && bin->size() >= *length) return Buffer{bin->first(*length), absent.length, fallback};
    if (fallback) return absent;
    if (i == 0 && bin) {
      gate.error(in(place, "byteLength"), "buffer-too-short",
                 fmt::format("is {}, but the BIN chunk has {} bytes", *length, bin->size()));
    } else {
      gate.error(place, "buffer-missing", "has no uri, and there is no BIN chunk for it",
                 "pack the file into a .glb, or name the file that holds the bytes");
    }
    return std::nullopt;
  }
  if (is_data_uri(*uri)) {
    auto data = decode_data_uri(*uri);
    if (!data) {
      gate.error(in(place, "uri"), "buffer-uri", "the data URI is not well-formed");
      return std::nullopt;
    }
    if (data->bytes.size() < *length) {
      gate.error(in(place, "uri"), "buffer-too-short",
                 fmt::format("holds {} bytes, but byteLength is {}", data->bytes.size(), *length));
      return std::nullopt;
    }
    gate.document().kept.push_back(std::move(data->bytes));
    return Buffer{Bytes(gate.document().kept.back()).first(*length), absent.length, fallback};
  }
  if (fallback && !may_be_beside(gate, *uri)) {
    gate.note(in(place, "uri"), "fallback-missing",
              fmt::format("the uncompressed copy '{}' is missing; the compressed data is used", *uri));
    return absent;
  }
  const auto bytes = file_beside(gate, *uri, *length, in(place, "uri"), files);
  return bytes ? std::optional(Buffer{*bytes, absent.length, fallback}) : std::nullopt;
}

}  // namespace

void check_buffers(Gate& gate, std::optional<Bytes> bin) {
  const Json& buffers = gate.all("buffers");
  FileBuffers files;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    gate.document().buffers.push_back(buffer_of(gate, i, buffers[i], bin, files).value_or(Buffer{}));
  }
}

std::uint64_t most_claimed(const Gate& gate) {
  std::uint64_t there = gate.document().file.size();
  for (const auto& bytes : gate.document().kept) there += bytes.size();
  return (std::uint64_t{64} << 20) + 16 * there;
}

void check_views(Gate& gate) {
  const Json& views = gate.all("bufferViews");
  gate.document().views.resize(views.size());
  const std::uint64_t most = most_claimed(gate);
  std::uint64_t claimed = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::string place = at("bufferViews", i);
    for (const char* key : {"buffer", "byteLength"}) gate.required(views[i], key, place);
    const auto number = gate.reference(views[i], "buffer", "buffers", place);
    const auto length = gate.whole(views[i], "byteLength", place, 1);
    const auto offset = gate.whole(views[i], "byteOffset", place);
    const auto stride = gate.whole(views[i], "byteStride", place, 4, 252);
    gate.whole(views[i], "target", place, 34962, 34963);
    if (stride && *stride % 4 != 0) {
      gate.error(in(place, "byteStride"), "view-stride", fmt::format("is {}, but must be a multiple of 4", *stride));
    }
    if (!number || !length) continue;
    // A buffer that was refused is told of once, not again for each view of it.
    const Buffer& buffer = gate.document().buffers[*number];
    const std::size_t size = buffer.length;
    if (size == 0) continue;
    if (offset.value_or(0) > size || *length > size - offset.value_or(0)) {
      gate.error(in(place, "byteLength"), "view-range",
                 fmt::format("{} bytes from byte {} do not fit in buffer {} of {} bytes", *length, offset.value_or(0),
                             *number, size));
      continue;
    }
    if (!buffer.bytes.empty()) claimed += *length;
    if (claimed > most) {
      gate.error(place, "overlap",
                 fmt::format("the buffer views up to this one claim {} bytes, because they overlap", claimed),
                 "let no two buffer views share bytes");
      return;
    }
    BufferView view{*number, offset.value_or(0), *length, stride.value_or(0), {}, std::nullopt};
    if (!buffer.bytes.empty()) view.bytes = buffer.bytes.subspan(view.offset, view.length);
    gate.document().views[i] = std::move(view);
  }
}

void check_images(Gate& gate) {
  const Json& images = gate.all("images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string place = at("images", i);
    const auto uri = gate.text(images[i], "uri", place);
    gate.reference(images[i], "bufferView", "bufferViews", place);
    gate.text(images[i], "mimeType", place);
    if (images[i].contains("uri") == images[i].contains("bufferView")) {
      gate.error(place, "image-source", "must have either a uri or a bufferView");
    }
    if (uri && is_data_uri(*uri) && !decode_data_uri(*uri)) {
      gate.error(in(place, "uri"), "image-source", "the data URI is not well-formed");
    }
  }
}

}  // namespace foredraw::gltf
