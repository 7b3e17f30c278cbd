// Checks of buffers, buffer views and images: where the bytes come from, and that there are as many as claimed.
#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/text/private/file_beside.h>
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

FilePlaces surroundings(const Gate& gate) { return {gate.document().folder, gate.how().root, gate.how().files}; }

/// The first `length` bytes of a file, or all where it has fewer; what may follow is not read.
std::optional<Bytes> bytes_beside(Gate& gate, const std::string& uri, std::uint64_t length, const std::string& place,
                                  FileBuffers& files) {
  const FileBeside beside = uri_beside(uri, surroundings(gate));
  if (!beside.why_not.empty()) {
    gate.error(place, beside.is_missing ? "buffer-missing" : "buffer-uri", fmt::format("'{}' {}", uri, beside.why_not),
               beside.hint + ", or pack both into a .glb");
    return std::nullopt;
  }
  const fs::path& file = beside.path;
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  length = std::min(length, error ? 0 : size);
  Bytes& known = files[fs::canonical(file, error)];
  if (known.size() >= length) return known.first(length);
  Diagnostics reading;
  // Twice what was read before: so that growing lengths do not have the file read again and again.
  auto bytes =
      read_file(file, reading, std::max<std::uint64_t>(length, std::min<std::uint64_t>(size, 2 * known.size())),
                gate.how().files.get());
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

/// By buffer, the extension that compressed all views of it, so that nobody needs its own bytes; nullptr: there is
/// none.
using Compressions = std::vector<const char*>;

Compressions compressions_of_buffers(const Gate& gate) {
  Compressions found(gate.count("buffers"), nullptr);
  std::vector<bool> has_plain_view(found.size(), false);
  for (const Json& view : gate.all("bufferViews")) {
    const auto named = view.find("buffer");
    if (named == view.end() || !named->is_number_unsigned() || *named >= found.size()) continue;
    const auto buffer = named->get<std::size_t>();
    const auto compression = std::ranges::find_if(
        meshopt_extensions, [&](const char* extension) { return extension_of(view, extension) != nullptr; });
    if (compression == std::end(meshopt_extensions)) {
      has_plain_view[buffer] = true;
    } else {
      found[buffer] = *compression;
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (has_plain_view[i]) found[i] = nullptr;
  }
  return found;
}

/// A buffer that has fewer bytes than it states.
std::optional<Buffer> shortened(Gate& gate, Bytes there, std::string message, const std::string& place) {
  if (there.empty()) {
    gate.error(in(place, "byteLength"), "buffer-too-short", std::move(message));
    return std::nullopt;
  }
  gate.fault("buffer-length", in(place, "byteLength"), std::move(message));
  gate.mend_at(in(place, "byteLength")) = there.size();
  return Buffer{there, there.size(), false, true};
}

std::optional<Buffer> buffer_of(Gate& gate, std::size_t i, const Json& json, std::optional<Bytes> bin,
                                const Compressions& compressions, FileBuffers& files) {
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
      return shortened(gate, *bin, fmt::format("is {}, but the BIN chunk has {} bytes", *length, bin->size()), place);
    }
    if (compressions[i] != nullptr && !json.contains("extensions")) {
      gate.fault("fallback", place, "has neither a uri nor a BIN chunk, and does not say that it is a fallback");
      gate.mend_at(place)["extensions"][compressions[i]]["fallback"] = true;
      return Buffer{{}, absent.length, true};
    }
    gate.error(place, "buffer-missing", "has no uri, and there is no BIN chunk for it",
               "pack the file into a .glb, or name the file that holds the bytes");
    return std::nullopt;
  }
  if (is_data_uri(*uri)) {
    auto data = decode_data_uri(*uri);
    if (!data) {
      gate.error(in(place, "uri"), "buffer-uri", "the data URI is not well-formed");
      return std::nullopt;
    }
    gate.document().kept.push_back(std::move(data->bytes));
    const Bytes there = gate.document().kept.back();
    if (there.size() < *length) {
      return shortened(gate, there, fmt::format("is {}, but the uri holds {} bytes", *length, there.size()), place);
    }
    return Buffer{Bytes(gate.document().kept.back()).first(*length), absent.length, fallback};
  }
  if (fallback && uri_beside(*uri, surroundings(gate)).is_missing) {
    gate.note(in(place, "uri"), "fallback-missing",
              fmt::format("the uncompressed copy '{}' is missing; the compressed data is used", *uri));
    return absent;
  }
  const auto bytes = bytes_beside(gate, *uri, *length, in(place, "uri"), files);
  if (!bytes) return std::nullopt;
  if (bytes->size() < *length) {
    return shortened(gate, *bytes, fmt::format("is {}, but '{}' has {} bytes", *length, *uri, bytes->size()), place);
  }
  return Buffer{*bytes, absent.length, fallback};
}

}  // namespace

void check_buffers(Gate& gate, std::optional<Bytes> bin) {
  const Json& buffers = gate.all("buffers");
  const Compressions compressions = compressions_of_buffers(gate);
  FileBuffers files;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    gate.document().buffers.push_back(buffer_of(gate, i, buffers[i], bin, compressions, files).value_or(Buffer{}));
  }
}

std::uint64_t most_claimed(const Gate& gate, std::uint64_t times) {
  std::uint64_t there = gate.document().file.size();
  for (const auto& bytes : gate.document().kept) there += bytes.size();
  return (std::uint64_t{64} << 20) + times * there;
}

namespace {

BufferView view_of(Gate& gate, const Json& json, const std::string& place) {
  for (const char* key : {"buffer", "byteLength"}) gate.required(json, key, place);
  const auto number = gate.reference(json, "buffer", "buffers", place);
  const auto length = gate.whole(json, "byteLength", place, 1);
  const auto offset = gate.whole(json, "byteOffset", place);
  const auto stride = gate.whole(json, "byteStride", place, 4, 252);
  gate.leave_out_if_wrong("view-target", in(place, "target"), [&] { gate.whole(json, "target", place, 34962, 34963); });
  if (stride && *stride % 4 != 0) {
    gate.error(in(place, "byteStride"), "view-stride", fmt::format("is {}, but must be a multiple of 4", *stride));
  }
  if (!number || !length) return {};
  // A buffer that was refused is told of once, not again for each view of it.
  const Buffer& buffer = gate.document().buffers[*number];
  const std::size_t size = buffer.length;
  if (size == 0) return {};
  std::uint64_t there = *length;
  if (offset.value_or(0) > size || *length > size - offset.value_or(0)) {
    const std::string message = fmt::format("{} bytes from byte {} do not fit in buffer {} of {} bytes", *length,
                                            offset.value_or(0), *number, size);
    if (buffer.bytes.empty() || buffer.is_cut || offset.value_or(0) >= size) {
      gate.error(in(place, "byteLength"), "view-range", message);
      return {};
    }
    gate.fault("view-length", in(place, "byteLength"), message);
    there = size - offset.value_or(0);
    gate.mend_at(in(place, "byteLength")) = there;
  }
  BufferView view{*number, offset.value_or(0), there, stride.value_or(0), {}, std::nullopt};
  if (!buffer.bytes.empty()) view.bytes = buffer.bytes.subspan(view.offset, view.length);
  return view;
}

/// A view without bytes gets one, behind its offset or, at the buffer's end, before it.
void fill_if_empty(Gate& gate, const Json& json, const std::string& place) {
  const auto length = json.find("byteLength");
  if (length == json.end() || !length->is_number_integer() || *length != 0) return;
  gate.fault("empty-view", in(place, "byteLength"), "is 0, but must be 1 at least");
  gate.mend_at(in(place, "byteLength")) = 1;
  const auto number = json.find("buffer"), offset = json.find("byteOffset");
  if (number == json.end() || offset == json.end() || !number->is_number_unsigned()) return;
  const auto buffer = number->get<std::size_t>();
  if (buffer < gate.count("buffers") && *offset > 0 && *offset == gate.document().buffers[buffer].length) {
    gate.mend_at(in(place, "byteOffset")) = offset->get<std::size_t>() - 1;
  }
}

}  // namespace

void check_views(Gate& gate) {
  const Json& views = gate.all("bufferViews");
  const std::uint64_t most = most_claimed(gate);
  std::uint64_t claimed = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::string place = at("bufferViews", i);
    fill_if_empty(gate, views[i], place);
    gate.document().views.push_back(gate.only_if_used("bufferViews", i, [&] {
      BufferView view = view_of(gate, views[i], place);
      if (view.bytes.size() > most - claimed) {
        gate.too_much(place, "overlap",
                      fmt::format("the buffer views up to this one claim {} bytes, because they overlap",
                                  claimed + view.bytes.size()),
                      "let no two buffer views share bytes");
        return BufferView();
      }
      claimed += view.bytes.size();
      return view;
    }));
  }
}

void check_images(Gate& gate) {
  const Json& images = gate.all("images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string place = at("images", i);
    const auto uri = gate.text(images[i], "uri", place);
    gate.reference(images[i], "bufferView", "bufferViews", place);
    gate.text(images[i], "mimeType", place);
    const bool has_uri = images[i].contains("uri");
    if (has_uri && images[i].contains("bufferView")) {
      gate.error(place, "image-source", "must have a uri or a bufferView, but has both");
    } else if (!has_uri && !images[i].contains("bufferView")) {
      gate.fault("image", place, "has neither a uri nor a bufferView");
    }
    if (uri && is_data_uri(*uri) && !decode_data_uri(*uri)) {
      gate.leave_out("image", in(place, "uri"), "the data URI is not well-formed");
    }
  }
}

}  // namespace foredraw::gltf
