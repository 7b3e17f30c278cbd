#pragma once
// Triangles that know their neighbours, whatever seams and copies their vertices have.

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::wire_radius {

inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// Vertices at one position, bit by bit, are one point. Triangles with the same three points are one, as where a strip
/// has a second side; those that are lines, or have a corner that is not finite, are none.
struct WeldedMesh {
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> point_of;                  ///< [vertex]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< three points each
  std::vector<std::uint32_t> triangle_of;               ///< [triangle of the mesh], or none
  std::vector<std::array<std::uint32_t, 3>> across;  ///< [triangle][edge] the other one at the edge from that corner to
                                                     ///< the next; none where there is no other one, or several
  std::vector<std::uint32_t> shell;                  ///< [triangle]: those that hang together across edges
  std::vector<double> shell_area;                    ///< [shell]
};

/// `indices`: three a triangle, each below the number of positions. O(n log n).
WeldedMesh weld_mesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace foredraw::processors::wire_radius
