// Checks of compressed buffer views, which are decompressed on the way. What a stream claims to hold is held against
// its bytes before memory is asked for.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

namespace foredraw::gltf {

namespace {

using Mode = Coding::Mode;
using Filter = Coding::Filter;

constexpr const char* compress_again =
    "compress it again for KHR_meshopt_compression, for instance with `gltfpack -cz`, or decompress it first";

/// What all streams together may stand for: so many times the bytes of all buffers, and what fits in any case. Version
/// 1 of the vertex codec can say a thousand times its bytes where all elements are equal.
constexpr std::uint64_t most_of_a_byte = 64;
constexpr std::uint64_t most_in_any_case = std::uint64_t{256} << 20;

class CompressionCheck {
 public:
  explicit CompressionCheck(Gate& gate) : gate_(gate) {
    std::map<const std::byte*, std::size_t> files;  // buffers may name the same bytes, which are there once
    for (const Buffer& buffer : gate.document().buffers) {
      std::size_t& bytes = files[buffer.bytes.data()];
      bytes = std::max(bytes, buffer.bytes.size());
    }
    for (const auto& [begin, bytes] : files) bytes_there_ += bytes;
  }

  /// False, with an error, where the view has no bytes.
  bool view(std::size_t v) {
    const Json& json = gate_.all("bufferViews")[v];
    BufferView& view = gate_.document().views[v];
    const std::string place = at("bufferViews", v);
    const auto is_in_it = [&](const char* name) { return extension_of(json, name) != nullptr; };
    const auto count = std::count_if(std::begin(meshopt_extensions), std::end(meshopt_extensions), is_in_it);
    if (count > 1) gate_.error(place, "compressed-twice", "is compressed by two extensions; expected one");
    if (count == 0 && view.length != 0 && view.bytes.empty()) refuse_absent(view, place);
    if (count != 1) return view.length != 0;
    const char* name = *std::find_if(std::begin(meshopt_extensions), std::end(meshopt_extensions), is_in_it);
    const std::string inside = in(in(place, "extensions"), name);
    const Json* extension = gate_.object(json["extensions"], name, in(place, "extensions"));
    if (extension == nullptr || view.length == 0 || !decompress(view, name, *extension, inside)) view.length = 0;
    return view.length != 0;
  }

 private:
  void refuse_absent(BufferView& view, const std::string& place) {
    gate_.error(place, "buffer-missing",
                fmt::format("lies in buffer {}, which is a fallback without bytes, but the view is not compressed",
                            view.buffer),
                "export the file again");
    view.length = 0;
  }

  bool decompress(BufferView& view, const std::string& name, const Json& json, const std::string& place) {
    auto compressed = compressed_of(view, json, place);
    if (!compressed) return false;
    compressed->extension = name;
    if (const std::string what = not_understood(*compressed, json); !what.empty()) {
      if (view.bytes.empty()) {
        gate_.error(place, "unsupported-extension", fmt::format("{}: {} is not supported", name, what), compress_again);
        return false;
      }
      compressed->understood = false;
      view.compressed = std::move(compressed);
      return true;
    }
    if (!fits(*compressed, place)) return false;
    auto plain = decompressed(compressed->coding, compressed->stream);
    if (!plain) {
      gate_.error(place, "compressed-data",
                  fmt::format("the {} bytes are not a valid stream of mode {}", compressed->stream.size(),
                              name_of(compressed->coding.mode)),
                  "export the file again; it was damaged on its way");
      return false;
    }
    if (!same_elements(compressed->coding, *plain, view.bytes)) {
      if (!view.bytes.empty()) {
        gate_.note(place, "plain-copy-differs",
                   "the uncompressed copy differs from the compressed data; the compressed data is used");
      }
      gate_.document().kept.push_back(std::move(*plain));
      view.bytes = gate_.document().kept.back();
    }
    view.compressed = std::move(compressed);
    return true;
  }

  std::optional<Compressed> compressed_of(const BufferView& view, const Json& json, const std::string& place) {
    for (const char* key : {"buffer", "byteLength", "byteStride", "count", "mode"}) gate_.required(json, key, place);
    const auto number = gate_.reference(json, "buffer", "buffers", place);
    const auto offset = gate_.whole(json, "byteOffset", place);
    const auto length = gate_.whole(json, "byteLength", place, 1);
    const auto stride = gate_.whole(json, "byteStride", place, 2, 256);
    const auto count = gate_.whole(json, "count", place, 1);
    const auto mode = gate_.text(json, "mode", place);
    const auto filter = gate_.text(json, "filter", place);
    const bool all = number && length && stride && count && mode;
    if (!all || (json.contains("filter") && !filter) || (json.contains("byteOffset") && !offset)) return std::nullopt;
    const Buffer& buffer = gate_.document().buffers[*number];
    if (buffer.length == 0) return std::nullopt;
    const std::size_t size = buffer.bytes.size();
    if (offset.value_or(0) > size || *length > size - offset.value_or(0)) {
      gate_.error(in(place, "byteLength"), "view-range",
                  fmt::format("{} bytes from byte {} do not fit in buffer {} of {} bytes", *length, offset.value_or(0),
                              *number, size));
      return std::nullopt;
    }
    if (*count > view.length / *stride || *count * *stride != view.length) {
      gate_.error(in(place, "count"), "compressed-count",
                  fmt::format("{} elements of {} bytes do not fill the {} bytes of the buffer view", *count, *stride,
                              view.length));
      return std::nullopt;
    }
    if (view.stride != 0 && view.stride != *stride) {
      gate_.error(in(place, "byteStride"), "view-stride",
                  fmt::format("is {}, but the byteStride of the buffer view is {}", *stride, view.stride));
      return std::nullopt;
    }
    Compressed result{{}, *number, static_cast<std::size_t>(offset.value_or(0)), {}, {}, true};
    result.stream = buffer.bytes.subspan(result.offset, static_cast<std::size_t>(*length));
    result.coding = {mode_of(*mode), filter_of(filter.value_or("NONE")), static_cast<std::size_t>(*count),
                     static_cast<std::size_t>(*stride),
                     meshopt::vertex_version(result.stream).value_or(meshopt::VertexVersion::v0)};
    return result;
  }

  static std::string not_understood(const Compressed& compressed, const Json& json) {
    if (compressed.coding.mode == Mode::unknown) return "the mode " + json["mode"].dump();
    if (compressed.coding.filter == Filter::unknown) return "the filter " + json["filter"].dump();
    return unknown_codec(compressed.coding.mode, compressed.stream);
  }

  /// Whether stride and count are as mode and filter want them, and the stream long enough to hold so many elements.
  bool fits(const Compressed& compressed, const std::string& place) {
    const Coding& coding = compressed.coding;
    const bool attributes = coding.mode == Mode::attributes;
    if (attributes ? coding.stride % 4 != 0 : coding.stride != 2 && coding.stride != 4) {
      gate_.error(in(place, "byteStride"), "view-stride",
                  fmt::format("is {}, but must be {}", coding.stride, attributes ? "a multiple of 4" : "2 or 4"));
      return false;
    }
    if (coding.mode == Mode::triangles && coding.count % 3 != 0) {
      gate_.error(in(place, "count"), "index-count",
                  fmt::format("{} indices are not a whole number of triangles", coding.count));
      return false;
    }
    const bool four = coding.filter == Filter::octahedral || coding.filter == Filter::color;
    const bool quaternion = coding.filter == Filter::quaternion && coding.stride != 8;
    if ((four && coding.stride != 4 && coding.stride != 8) || quaternion ||
        (!attributes && coding.filter != Filter::none)) {
      gate_.error(
          in(place, "filter"), "compressed-filter",
          fmt::format("{} cannot be used in mode {} with a byteStride of {}", name_of(coding.filter),
                      name_of(coding.mode), coding.stride),
          "OCTAHEDRAL and COLOR take 4 or 8 bytes, QUATERNION 8, EXPONENTIAL a multiple of 4; each in mode ATTRIBUTES");
      return false;
    }
    const std::size_t least = least_stream_bytes(coding);
    if (compressed.stream.size() < least) {
      gate_.error(in(place, "count"), "compressed-count",
                  fmt::format("{} elements of {} bytes take at least {} compressed bytes, but there are {}",
                              coding.count, coding.stride, least, compressed.stream.size()));
      return false;
    }
    // Streams may lie over each other, but a short file must not ask for the same one again and again.
    if (compressed.stream.size() > bytes_there_ - taken_) {
      gate_.too_much(
          in(place, "byteLength"), "view-range",
          fmt::format("the compressed bytes of the views so far are more than the {} of all buffers", bytes_there_));
      return false;
    }
    if (coding.bytes() > most_of_a_byte * bytes_there_ + most_in_any_case - made_) {
      gate_.too_much(
          in(place, "count"), "compressed-count",
          fmt::format("the compressed views up to this one stand for {} bytes, which is too much for the {} of "
                      "all buffers",
                      made_ + coding.bytes(), bytes_there_),
          "if the file is right, export it without compression");
      return false;
    }
    taken_ += compressed.stream.size();
    made_ += coding.bytes();
    return true;
  }

  Gate& gate_;
  std::size_t bytes_there_ = 0;
  std::size_t taken_ = 0;
  std::uint64_t made_ = 0;
};

}  // namespace

void check_compression(Gate& gate) {
  CompressionCheck check(gate);
  for (std::size_t v = 0; v < gate.count("bufferViews"); ++v) {
    gate.only_if_used("bufferViews", v, [&] { return check.view(v); });
  }
}

}  // namespace foredraw::gltf
