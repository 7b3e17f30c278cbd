#pragma once
// Several draws as one mesh.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <span>

namespace foredraw {

/// Draws that use the same VertexStreams share its vertices.
struct JoinedMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;       ///< three a triangle, draw after draw
  std::vector<std::uint32_t> part;          ///< [vertex] which of `streams` it is of
  std::vector<std::uint32_t> first_index;   ///< [draw], and the number of indices
  std::vector<std::uint32_t> first_vertex;  ///< [stream], and the number of vertices
  std::vector<std::shared_ptr<const VertexStreams>> streams;
  std::vector<std::uint32_t> stream_of;  ///< [draw]
};

/// Of full detail. Nothing where a number names no draw of triangles, or there are more than 2^31 vertices or indices.
std::optional<JoinedMesh> joined_mesh(const Scene& scene, std::span<const DrawId> draws, Analyses& analyses);

}  // namespace foredraw
