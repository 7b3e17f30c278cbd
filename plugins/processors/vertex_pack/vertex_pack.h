#pragma once
// Vertices in 128 bits, many at once: what runtime/packed_vertex.h does one by one, to the same bits.
//
// N. Tatarchuk, J. Barczak, B. Purnomo: tessellated crowds, AMD 2008, "vertex compression".

#include <foredraw/packing/packed_vertices.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Each as many as there are vertices, or none: then its fields become 0, or are not decoded.
struct PlainVertices {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::vec4> tangents;  ///< the last one is the handedness; packed only with normals
  std::span<const glm::vec2> uvs;
};
struct UnpackedVertices {
  std::span<glm::vec3> positions, normals;
  std::span<glm::vec4> tangents;
  std::span<glm::vec2> uvs;
};

/// Four words a vertex. Answers with what the rows do not hold as it was, of any vertex: FOREDRAW_PACKED_*. A layout
/// for which foredraw_packed_is_layout() holds.
std::uint32_t pack_vertices(const PackedLayout& layout, const PlainVertices& from, std::span<std::uint32_t> rows);

/// Rows, and what they do not hold as it was.
struct PackedStreams {
  std::vector<std::uint32_t> rows;
  std::uint32_t told = 0;
};

/// Of POSITION, NORMAL, TANGENT and TEXCOORD_0.
PackedStreams pack_streams(const PackedLayout& layout, const VertexStreams& vertices);

/// What the layout does not have becomes 0.
void unpack_vertices(const PackedLayout& layout, std::span<const std::uint32_t> rows, const UnpackedVertices& to);

struct Plugin;
Plugin vertex_pack_plugin();

}  // namespace foredraw
