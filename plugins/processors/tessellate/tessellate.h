#pragma once
// Planar subdivision with displacement: what the shaders show, as plain triangles.
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes.

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/scene/vertex_streams.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// A triangle list whose vertices move along a direction of their own, by a map.
struct DisplacedSurface {
  const VertexStreams& vertices;                        ///< with POSITION
  std::span<const std::uint32_t> indices;               ///< three a triangle
  std::span<const glm::vec3> directions;                ///< [vertex] smooth_directions()
  std::span<const std::array<std::int32_t, 2>> places;  ///< [vertex] height_places()
  foredraw_height_map map;
  float factor = 1, offset = 0;  ///< units
};

struct Tessellated {
  VertexStreams vertices;  ///< positions are floats
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> source;  ///< [triangle] the one that it lies on; rising
};

/// Divides each triangle by its levels (tessellated_mesh()), interpolates all streams (interpolated()) and moves the
/// positions (foredraw_displaced_point()). Normals are those of the moved surface, with the creases that it had, unless
/// `keeps_normals`: a normal map refers to those that there were. Throws as tessellated_mesh() does.
Tessellated tessellate(const DisplacedSurface& surface, std::span<const TessellationLevels> levels,
                       TessellationSpacing spacing, bool keeps_normals = false);

struct Plugin;
Plugin tessellate_plugin();

}  // namespace foredraw
