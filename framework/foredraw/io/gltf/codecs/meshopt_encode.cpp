// Bytes to streams of the meshopt codecs.
#include <foredraw/io/gltf/codecs/private/meshopt.h>
#include <foredraw/io/gltf/private/rows.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace foredraw::gltf {

namespace {

using Mode = Coding::Mode;
using Filter = Coding::Filter;
using Bytes = std::span<const std::byte>;

unsigned char* raw(std::vector<std::byte>& bytes) { return reinterpret_cast<unsigned char*>(bytes.data()); }

Stream vertex_stream(const Coding& coding, Bytes elements) {
  return {coding, meshopt::encode_vertices(elements, coding.stride, coding.version)};
}

Stream index_stream(const Coding& coding, const std::vector<std::uint32_t>& indices) {
  // The extensions allow version 1 alone, which is a setting of the process: told once, before any thread relies on it.
  static const bool told = (meshopt_encodeIndexVersion(1), true);
  static_cast<void>(told);
  const std::size_t vertices = std::size_t{*std::max_element(indices.begin(), indices.end())} + 1;
  const bool triangles = coding.mode == Mode::triangles;
  const std::size_t most = triangles ? meshopt_encodeIndexBufferBound(indices.size(), vertices)
                                     : meshopt_encodeIndexSequenceBound(indices.size(), vertices);
  Stream stream{coding, std::vector<std::byte>(most)};
  stream.bytes.resize(triangles ? meshopt_encodeIndexBuffer(raw(stream.bytes), most, indices.data(), indices.size())
                                : meshopt_encodeIndexSequence(raw(stream.bytes), most, indices.data(), indices.size()));
  return stream;
}

bool gives(const Stream& stream, Bytes elements) {
  const auto again = decompressed(stream.coding, stream.bytes);
  return again && same_elements(stream.coding, *again, elements);
}

/// For each element one of which the filter makes it, taken from what was there; nullopt where there is none for some.
std::optional<std::vector<std::byte>> taken_along(Bytes elements, const Coding& like, Bytes like_stream) {
  const auto raw = unfiltered(like, like_stream);
  if (!raw) return std::nullopt;
  std::vector<std::byte> made = *raw;
  apply_filter(like, made);
  const auto element = [&](Bytes all, std::size_t at) {
    return std::string_view(reinterpret_cast<const char*>(all.data()) + at, like.stride);
  };
  std::unordered_map<std::string_view, std::size_t> places;  // only looked up, so its own sequence does not show
  for (std::size_t at = 0; at < made.size(); at += like.stride) places.try_emplace(element(made, at), at);
  std::vector<std::byte> result(elements.size());
  for (std::size_t at = 0; at < elements.size(); at += like.stride) {
    const auto found = places.find(element(elements, at));
    if (found == places.end()) return std::nullopt;
    std::memcpy(result.data() + at, raw->data() + found->second, like.stride);
  }
  return result;
}

bool has_filter(const Coding& coding) { return coding.filter != Filter::none && coding.filter != Filter::unknown; }

std::optional<Stream> compressed_attributes(Bytes elements, Coding coding, const Coding& like, Bytes like_stream) {
  if (coding.stride % 4 != 0 || coding.stride > 256) return std::nullopt;
  if (has_filter(like) && coding.stride == like.stride) {
    if (const auto rows = taken_along(elements, like, like_stream)) {
      coding.filter = like.filter;
      return vertex_stream(coding, *rows);
    }
  }
  Stream shortest = vertex_stream(coding, elements);
  for (const Filter filter : {Filter::octahedral, Filter::quaternion, Filter::exponential}) {
    auto rows = before_filter(filter, coding.stride, elements);
    if (!rows) continue;
    coding.filter = filter;
    if (filter == Filter::exponential) rows = raised_where_shorter(*rows, coding.stride, coding.version);
    Stream filtered = vertex_stream(coding, *rows);
    if (filtered.bytes.size() < shortest.bytes.size()) shortest = std::move(filtered);
  }
  return shortest;
}

std::optional<Stream> compressed_indices(Bytes elements, Coding coding) {
  if (coding.stride != 2 && coding.stride != 4) return std::nullopt;
  const std::vector<std::uint32_t> indices = widened(elements, coding.stride);
  const Mode wanted = std::exchange(coding.mode, Mode::indices);
  Stream stream = index_stream(coding, indices);
  if (wanted != Mode::triangles || indices.size() % 3 != 0) return stream;
  coding.mode = Mode::triangles;
  Stream triangles = index_stream(coding, indices);
  return triangles.bytes.size() < stream.bytes.size() ? std::move(triangles) : std::move(stream);
}

bool same_triangles(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  for (std::size_t i = 0; i + 2 < a.size(); i += 3) {
    bool same = false;
    for (std::size_t turn = 0; turn < 3; ++turn) {
      same = same || (a[i] == b[i + turn] && a[i + 1] == b[i + (turn + 1) % 3] && a[i + 2] == b[i + (turn + 2) % 3]);
    }
    if (!same) return false;
  }
  return true;
}

}  // namespace

bool same_elements(const Coding& coding, Bytes a, Bytes b) {
  if (std::equal(a.begin(), a.end(), b.begin(), b.end())) return true;
  return coding.mode == Mode::triangles && a.size() == b.size() &&
         same_triangles(widened(a, coding.stride), widened(b, coding.stride));
}

std::optional<Stream> compressed(Bytes elements, std::size_t stride, const Coding& like, Bytes like_stream) {
  if (like.mode == Mode::unknown || stride == 0 || elements.empty() || elements.size() % stride != 0)
    return std::nullopt;
  const Coding coding{like.mode, Filter::none, elements.size() / stride, stride, like.version};
  auto stream = like.mode == Mode::attributes ? compressed_attributes(elements, coding, like, like_stream)
                                              : compressed_indices(elements, coding);
  // What a stream does not give back is not written: the plain bytes are.
  return stream && gives(*stream, elements) ? std::move(stream) : std::nullopt;
}

}  // namespace foredraw::gltf
