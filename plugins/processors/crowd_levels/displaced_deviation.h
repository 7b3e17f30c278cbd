#pragma once
// How far a tessellated surface is from the finest one.

#include <foredraw/base/parallel.h>
#include <foredraw/displaced/displaced_mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// A triangle list whose vertices move along a direction of their own, by a map.
struct MovedSurface {
  std::span<const std::uint32_t> indices;               ///< three a triangle
  std::span<const glm::vec3> positions;                 ///< [vertex]
  std::span<const glm::vec3> directions;                ///< [vertex] smooth_directions()
  std::span<const std::array<std::int32_t, 2>> places;  ///< [vertex] height_places()
  foredraw_height_map map;
  float factor = 1, offset = 0;  ///< units
};

struct Deviation {
  double largest = 0;
  double rms = 0;  ///< by the area of the triangles, before they are moved
};

/// [0] of the triangles as they are, not moved; [1 + i] with parts[i] parts to each edge, all in equal spacing. Held
/// against the surface of `finest` parts at each of its points: the point of the coarser one at the same place of the
/// triangle. So no true distance from the finer surface to the coarser one is larger. Triangles with a corner that is
/// not finite are left out. O(triangles * finest^2 * parts.size()). The same at any number of threads.
std::vector<Deviation> displaced_deviations(const MovedSurface& surface, std::span<const std::uint32_t> parts,
                                            std::uint32_t finest, const Executor& executor);

/// Of full detail, by which its rms weighs. Triangles that are not finite have none.
double area_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace foredraw
