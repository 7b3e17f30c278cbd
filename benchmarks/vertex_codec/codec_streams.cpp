#include "codec_streams.h"

#include "bench_meshes.h"

#include <foredraw/io/scene_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace foredraw::bench {

namespace {

using Bytes = std::vector<std::byte>;

/// Floats as normalized numbers of type T over the range that they have together, each element padded to whole words.
template <class T>
Bytes quantised(const VertexStream& stream) {
  const std::size_t components = stream.format.components;
  const std::size_t padded = (components * sizeof(T) + 3) / 4 * 4 / sizeof(T);
  float least = std::numeric_limits<float>::max(), most = -least;
  for (std::size_t i = 0; i < stream.count() * components; ++i) {
    const float value = decode_component(stream, i / components, i % components);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  const float scale = most > least ? static_cast<float>(std::numeric_limits<T>::max()) / (most - least) : 0;
  std::vector<T> values(stream.count() * padded);
  for (std::size_t i = 0; i < stream.count() * components; ++i) {
    const float value = decode_component(stream, i / components, i % components);
    values[i / components * padded + i % components] = static_cast<T>(std::lround((value - least) * scale));
  }
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

void add(std::map<std::string, StreamSet>& sets, const std::string& name, std::size_t stride, Bytes bytes) {
  StreamSet& set = sets[fmt::format("{}, {} bytes", name, stride)];
  set.name = fmt::format("{}, {} bytes", name, stride);
  set.stride = stride;
  set.streams.push_back(std::move(bytes));
}

void add_quantised(std::map<std::string, StreamSet>& sets, const VertexStream& stream) {
  if (stream.format.component != Component::float32) return;
  if (stream.semantic == "POSITION") add(sets, "POSITION as 16 bits", 8, quantised<std::uint16_t>(stream));
  if (stream.semantic == "NORMAL") add(sets, "NORMAL as 8 bits", 4, quantised<std::uint8_t>(stream));
  if (stream.semantic == "TEXCOORD_0") add(sets, "TEXCOORD_0 as 16 bits", 4, quantised<std::uint16_t>(stream));
}

}  // namespace

std::size_t StreamSet::bytes() const {
  std::size_t sum = 0;
  for (const Bytes& stream : streams) sum += stream.size();
  return sum;
}

std::vector<StreamSet> streams_of(const std::vector<std::string>& files) {
  std::map<std::string, StreamSet> sets;
  for (const std::string& file : files) {
    Diagnostics diagnostics;
    const auto scene = read_scene(file, diagnostics);
    if (!scene) throw std::runtime_error(to_text(diagnostics));
    std::set<const void*> seen;  // draws may share their vertices
    for (const Draw& draw : scene->scene.draws) {
      const VertexStreams& vertices = *draw.levels[0].vertices;
      if (!seen.insert(&vertices).second) continue;
      for (const VertexStream* stream : vertices.all()) {
        const auto bytes = stream->bytes.view();
        if (stream->format.bytes % 4 != 0 || bytes.empty()) continue;
        add(sets, stream->semantic, stream->format.bytes, {bytes.begin(), bytes.end()});
        add_quantised(sets, *stream);
      }
    }
  }
  std::vector<StreamSet> all;
  for (auto& [name, set] : sets) all.push_back(std::move(set));
  return all;
}

std::vector<StreamSet> growing_streams() {
  std::vector<StreamSet> all;
  for (const MeshSet& size : subdivisions("static/spot.glb", {0, 2, 4})) {
    const auto& positions = size.meshes[0].positions;
    const auto bytes = std::as_bytes(std::span(positions));
    const VertexStream stream{
        "POSITION", {Component::float32, 3, false, 12}, Shared<std::byte>(Bytes(bytes.begin(), bytes.end()))};
    all.push_back({fmt::format("Spot, {} vertices, 12 bytes", positions.size()), 12, {{bytes.begin(), bytes.end()}}});
    all.push_back({fmt::format("Spot, {} vertices, as 16 bits, 8 bytes", positions.size()),
                   8,
                   {quantised<std::uint16_t>(stream)}});
  }
  return all;
}

}  // namespace foredraw::bench
