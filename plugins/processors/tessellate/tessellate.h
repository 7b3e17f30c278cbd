#pragma once
// Planar subdivision with displacement: what the shaders show, as plain triangles.
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes.

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/scene/vertex_streams.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct Tessellated {
  VertexStreams vertices;  ///< positions are floats
  std::vector<std::uint32_t> indices;
};

/// The points of a mesh that a triangle list was divided into, moved, with all streams that the list has
/// (displaced_streams()).
Tessellated tessellate(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                       std::span<const glm::vec3> directions, const TessellatedMesh& mesh,
                       std::span<const float> displacements, bool keeps_normals = false);

struct Plugin;
Plugin tessellate_plugin();

}  // namespace foredraw
