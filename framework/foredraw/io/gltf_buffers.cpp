// Checks of buffers, buffer views and images: where the bytes come from, and that there are as many as claimed.
#include <foredraw/io/private/gltf_gate.h>
#include <foredraw/io/private/gltf_uri.h>
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
    gate.error(place, "buffer-uri", fmt::format("'{}' {}; a file in the folder of the glTF was expected", uri, why),
               "put the file beside the glTF and name it by a relative path, or pack both into a .glb");
    return std::nullopt;
  }
  if (folder.empty()) {
    gate.error(place, "buffer-missing",
               fmt::format("'{}' can not be looked for: the glTF was not read from a folder", uri),
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
  auto bytes = read_file(file, reading, std::max<std::uint64_t>(length, std::min<std::uint64_t>(size, 2 * known.size())));
  if (!bytes || bytes->size() < length) {
    gate.error(place, "buffer-missing",
               bytes ? "the file got shorter while it was read" : reading.all().front().message);
    return std::nullopt;
  }
  gate.document().kept.push_back(std::move(*bytes));
  known = gate.document().kept.back();
  return known.first(length);
}

std::optional<Bytes> bytes_of_buffer(Gate& gate, std::size_t i, const Json& buffer, std::optional<Bytes> bin,
                                     FileBuffers& files) {
  const std::string place = at("buffers", i);
  gate.required(buffer, "byteLength", place);
  const auto length = gate.whole(buffer, "byteLength", place, 1);
  const auto uri = gate.text(buffer, "uri", place);
  if (!length) return std::nullopt;
  if (!uri && buffer.contains("uri")) return std::nullopt;

  if (!uri) {
    if (i == 0 && bin && bin->size() >= *length) return bin->first(*length);
    if (i == 0 && bin) {
      gate.error(in(place, "byteLength"), "buffer-too-short",
                 fmt::format("is {}, but the BIN chunk has {} bytes", *length, bin->size()));
    } else {
      gate.error(place, "buffer-missing", "has no uri, and there is no BIN chunk for it",
                 "if its views are compressed (EXT_meshopt_compression), decode the file first, for instance with "
                 "`gltf-transform copy in.glb out.glb`");
    }
    return std::nullopt;
  }
  if (!is_data_uri(*uri)) return file_beside(gate, *uri, *length, in(place, "uri"), files);
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
  return Bytes(gate.document().kept.back()).first(*length);
}

}  // namespace

void check_buffers(Gate& gate, std::optional<Bytes> bin) {
  const Json& buffers = gate.all("buffers");
  FileBuffers files;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    gate.document().buffers.push_back(bytes_of_buffer(gate, i, buffers[i], bin, files).value_or(Bytes{}));
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
    const auto buffer = gate.reference(views[i], "buffer", "buffers", place);
    const auto length = gate.whole(views[i], "byteLength", place, 1);
    const auto offset = gate.whole(views[i], "byteOffset", place);
    const auto stride = gate.whole(views[i], "byteStride", place, 4, 252);
    gate.whole(views[i], "target", place, 34962, 34963);
    if (stride && *stride % 4 != 0) {
      gate.error(in(place, "byteStride"), "view-stride", fmt::format("is {}, but must be a multiple of 4", *stride));
    }
    if (!buffer || !length) continue;
    // A buffer that was refused is told of once, not again for each view of it.
    const std::size_t size = gate.document().buffers[*buffer].size();
    if (size == 0) continue;
    if (offset.value_or(0) > size || *length > size - offset.value_or(0)) {
      gate.error(in(place, "byteLength"), "view-range",
                 fmt::format("{} bytes from {} do not lie in buffer {} of {} bytes", *length, offset.value_or(0),
                             *buffer, size));
      continue;
    }
    claimed += *length;
    if (claimed > most) {
      gate.error(place, "overlap", fmt::format("the buffer views up to this one claim {} bytes: they lie over one another",
                                               claimed), "give each byte to one buffer view");
      return;
    }
    gate.document().views[i] = BufferView{*buffer, offset.value_or(0), *length, stride.value_or(0)};
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
