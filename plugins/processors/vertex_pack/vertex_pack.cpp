#include "vertex_pack.h"

#include <vector>

namespace foredraw {

namespace {

/// A stream's vectors; empty where there is none of so many components and vertices.
template <class Vector>
std::vector<Vector> decoded(const VertexStreams& vertices, std::string_view semantic) {
  constexpr int components = Vector::length();
  const VertexStream* stream = vertices.find(semantic);
  if (stream == nullptr || stream->format.components < components || stream->count() < vertices.count) return {};
  std::vector<Vector> values(vertices.count);
  for (std::size_t v = 0; v < values.size(); ++v) {
    for (int c = 0; c < components; ++c) values[v][c] = decode_component(*stream, v, static_cast<std::size_t>(c));
  }
  return values;
}

}  // namespace

PackedStreams pack_streams(const PackedLayout& layout, const VertexStreams& vertices) {
  const auto positions = decoded<glm::vec3>(vertices, "POSITION");
  const auto normals = decoded<glm::vec3>(vertices, "NORMAL");
  const auto tangents = decoded<glm::vec4>(vertices, "TANGENT");
  const auto uvs = decoded<glm::vec2>(vertices, "TEXCOORD_0");
  PackedStreams packed{std::vector<std::uint32_t>(std::size_t{4} * vertices.count), 0};
  packed.told = pack_vertices(layout, {positions, normals, tangents, uvs}, packed.rows);
  return packed;
}

}  // namespace foredraw
