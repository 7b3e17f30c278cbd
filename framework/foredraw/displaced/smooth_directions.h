#pragma once
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// One draw of a surface.
struct DirectedPart {
  std::span<const glm::vec3> positions;    ///< [vertex]
  std::span<const glm::vec3> normals;      ///< [vertex] that a stored direction is made of; empty: faces' normals are
  std::span<const std::uint32_t> indices;  ///< a triangle list
};

/// [part][vertex] Where displacement moves the surface: one unit direction for each position, whatever vertices of
/// whatever parts lie there. Along normals that differ at one position a displaced surface tears.
///
/// A direction is the sum of the normals at the corners that lie there, weighted by the angles' sines over the lengths
/// of the sides (N. Max: Weights for Computing Vertex Normals from Facet Normals, JGT 1999), so it hangs neither on how
/// many vertices there are nor on how a flat face is cut into triangles. Where stored normals cancel each other out, or
/// are no numbers, faces' normals count; where these do, too, the direction is 0, and nothing moves. O(n log n).
std::vector<std::vector<glm::vec3>> smooth_directions(std::span<const DirectedPart> parts);

}  // namespace foredraw
