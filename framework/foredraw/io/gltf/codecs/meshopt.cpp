// Streams of the meshopt codecs to bytes.
#include <foredraw/io/gltf/codecs/private/meshopt.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <utility>

namespace foredraw::gltf {

namespace {

using Mode = Coding::Mode;
using Filter = Coding::Filter;

constexpr std::pair<Mode, const char*> modes[] = {
    {Mode::attributes, "ATTRIBUTES"}, {Mode::triangles, "TRIANGLES"}, {Mode::indices, "INDICES"}};
constexpr std::pair<Filter, const char*> filters[] = {{Filter::none, "NONE"},
                                                      {Filter::octahedral, "OCTAHEDRAL"},
                                                      {Filter::quaternion, "QUATERNION"},
                                                      {Filter::exponential, "EXPONENTIAL"},
                                                      {Filter::color, "COLOR"}};

/// A stream's first byte: the codec in its high half, the version in the low one.
struct Codec {
  const char* name;
  unsigned byte;
  unsigned newest;  ///< version that there is a decoder for
};

Codec codec_of(Mode mode) {
  if (mode == Mode::attributes) return {"vertex codec", 0xa0, 1};
  if (mode == Mode::triangles) return {"triangle codec", 0xe0, 1};
  return {"index codec", 0xd0, 1};
}

}  // namespace

Mode mode_of(std::string_view name) {
  const auto found = std::find_if(std::begin(modes), std::end(modes), [&](const auto& m) { return name == m.second; });
  return found == std::end(modes) ? Mode::unknown : found->first;
}

Filter filter_of(std::string_view name) {
  const auto found =
      std::find_if(std::begin(filters), std::end(filters), [&](const auto& f) { return name == f.second; });
  return found == std::end(filters) ? Filter::unknown : found->first;
}

const char* name_of(Mode mode) {
  return std::find_if(std::begin(modes), std::end(modes), [&](const auto& m) { return mode == m.first; })->second;
}

const char* name_of(Filter filter) {
  return std::find_if(std::begin(filters), std::end(filters), [&](const auto& f) { return filter == f.first; })->second;
}

std::string unknown_codec(Mode mode, std::span<const std::byte> stream) {
  const Codec codec = codec_of(mode);
  const unsigned first = stream.empty() ? 0 : std::to_integer<unsigned>(stream[0]);
  if ((first & 0xf0) != codec.byte || (first & 0x0f) <= codec.newest) return {};
  return std::string(codec.name) + " version " + std::to_string(first & 0x0f);
}

std::size_t least_stream_bytes(const Coding& coding) {
  switch (coding.mode) {
    case Mode::attributes: return meshopt::least_vertex_bytes(coding.count, coding.stride, coding.version);
    case Mode::triangles: return 1 + coding.count / 3 + 16;  // a byte a triangle, and a table of 16
    case Mode::indices: return 1 + coding.count + 4;         // a byte an index, and 4 of padding
    case Mode::unknown: break;
  }
  return 0;
}

std::optional<std::vector<std::byte>> unfiltered(const Coding& coding, std::span<const std::byte> stream) {
  std::vector<std::byte> result(coding.bytes());
  const auto* from = reinterpret_cast<const unsigned char*>(stream.data());
  const auto decode = [&] {
    if (coding.mode == Mode::attributes) return meshopt::decode_vertices(stream, coding.stride, result);
    if (coding.mode == Mode::triangles) {
      return meshopt_decodeIndexBuffer(result.data(), coding.count, coding.stride, from, stream.size()) == 0;
    }
    return meshopt_decodeIndexSequence(result.data(), coding.count, coding.stride, from, stream.size()) == 0;
  };
  return decode() ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<std::vector<std::byte>> decompressed(const Coding& coding, std::span<const std::byte> stream) {
  auto elements = unfiltered(coding, stream);
  if (elements) apply_filter(coding, *elements);
  return elements;
}

}  // namespace foredraw::gltf
