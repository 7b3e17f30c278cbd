#include <foredraw/wires/wires.h>

#include <array>
#include <string>

namespace foredraw {

namespace {

/// Where a vertex's eight numbers are: four streams of two, or two of four.
std::vector<const VertexStream*> streams_of(const VertexStreams& vertices, std::optional<std::uint32_t> texcoords) {
  if (!texcoords) return {vertices.find(wire_semantic), vertices.find(wire_axis_semantic)};
  std::vector<const VertexStream*> streams;
  for (std::uint32_t set = *texcoords; set < *texcoords + 4; ++set) {
    streams.push_back(vertices.find("TEXCOORD_" + std::to_string(set)));
  }
  return streams;
}

}  // namespace

std::optional<DecodedWires> decoded_wires(const VertexStreams& vertices, std::optional<std::uint32_t> texcoords) {
  const std::vector<const VertexStream*> streams = streams_of(vertices, texcoords);
  const std::size_t components = 8 / streams.size();
  for (const VertexStream* stream : streams) {
    const bool fits = stream != nullptr && stream->format.component == Component::float32 &&
                      stream->format.components == components && stream->count() == vertices.count;
    if (!fits) return std::nullopt;
  }
  DecodedWires result{std::vector<glm::vec4>(vertices.count), std::vector<glm::vec4>(vertices.count)};
  for (std::size_t v = 0; v < vertices.count; ++v) {
    std::array<float, 8> numbers{};
    for (std::size_t i = 0; i < 8; ++i) numbers[i] = decode_component(*streams[i / components], v, i % components);
    result.wires[v] = {numbers[0], numbers[1], numbers[2], numbers[3]};
    result.axes[v] = {numbers[4], numbers[5], numbers[6], numbers[7]};
  }
  return result;
}

}  // namespace foredraw
