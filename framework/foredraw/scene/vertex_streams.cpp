#include <foredraw/scene/vertex_streams.h>

#include <algorithm>
#include <limits>

namespace foredraw {

std::size_t bytes_of(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8: return 1;
    case Component::int16:
    case Component::uint16: return 2;
    case Component::uint32:
    case Component::float32: return 4;
  }
  return 4;
}

const VertexStream* VertexStreams::find(std::string_view semantic) const {
  const auto it = std::find_if(base.begin(), base.end(), [&](const auto& s) { return s.semantic == semantic; });
  return it == base.end() ? nullptr : &*it;
}

std::vector<const VertexStream*> VertexStreams::all() const {
  std::vector<const VertexStream*> streams;
  for (const VertexStream& stream : base) streams.push_back(&stream);
  for (const auto& target : morph_targets) {
    for (const VertexStream& stream : target) streams.push_back(&stream);
  }
  return streams;
}

Stamp VertexStreams::layout_stamp() const {
  std::vector<Stamp> stamps;
  const auto add = [&](const std::vector<VertexStream>& list) {
    for (const VertexStream& stream : list) {
      stamps.push_back(content_hash(std::span<const char>(stream.semantic)));
      const std::uint32_t format[] = {static_cast<std::uint32_t>(stream.format.component), stream.format.components,
                                      stream.format.normalized, stream.format.bytes};
      stamps.push_back(content_hash(std::span<const std::uint32_t>(format)));
    }
    stamps.push_back({});  // where one list ends and the next begins
  };
  add(base);
  for (const auto& target : morph_targets) add(target);
  return combine(stamps);
}

Stamp VertexStreams::stamp() const {
  std::vector<Stamp> stamps = {layout_stamp(), {0, count}};
  for (const VertexStream* stream : all()) stamps.push_back(stream->bytes.stamp());
  return combine(stamps);
}

std::size_t VertexStreams::bytes_per_vertex() const {
  std::size_t bytes = 0;
  for (const VertexStream& stream : base) bytes += stream.format.bytes;
  return bytes;
}

namespace {

template <class T>
float load(const std::byte* from, bool normalized) {
  T value;
  std::memcpy(&value, from, sizeof value);
  if constexpr (std::is_same_v<T, float>) return value;
  if (!normalized) return static_cast<float>(value);
  const float scaled = static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
  return std::max(scaled, -1.0f);
}

}  // namespace

float decode_component(const VertexStream& stream, std::size_t element, std::size_t component) {
  const std::byte* from =
      stream.bytes.view().data() + element * stream.format.bytes + component * bytes_of(stream.format.component);
  switch (stream.format.component) {
    case Component::int8: return load<std::int8_t>(from, stream.format.normalized);
    case Component::uint8: return load<std::uint8_t>(from, stream.format.normalized);
    case Component::int16: return load<std::int16_t>(from, stream.format.normalized);
    case Component::uint16: return load<std::uint16_t>(from, stream.format.normalized);
    case Component::uint32: return load<std::uint32_t>(from, stream.format.normalized);
    case Component::float32: return load<float>(from, false);
  }
  return 0;
}

std::vector<glm::vec3> decode_vec3(const VertexStream& stream) {
  std::vector<glm::vec3> values(stream.count(), glm::vec3(0));
  const std::size_t components = std::min<std::size_t>(3, stream.format.components);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t c = 0; c < components; ++c) values[i][static_cast<int>(c)] = decode_component(stream, i, c);
  }
  return values;
}

}  // namespace foredraw
