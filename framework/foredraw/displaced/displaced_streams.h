#pragma once
// The vertices of a displaced mesh, with all that they have.

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/scene/vertex_streams.h>

#include <cstdint>
#include <span>

namespace foredraw {

/// Interpolates all streams of a triangle list for the points of a mesh that it was divided into (interpolated()), and
/// moves the positions (displaced_positions()), which become floats. `directions`: [vertex] smooth_directions();
/// `displacements`: [vertex of the mesh] units. Normals become those of the moved surface, with the creases that it
/// had, unless `keeps_normals`: a normal map refers to those that there were.
VertexStreams displaced_streams(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                                std::span<const glm::vec3> directions, const TessellatedMesh& mesh,
                                std::span<const float> displacements, bool keeps_normals);

}  // namespace foredraw
