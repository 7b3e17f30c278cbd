#pragma once
// Points all over a surface.

#include <foredraw/analysis/closest_points.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foredraw {

/// A point of a triangle.
struct SurfacePoint {
  std::uint32_t triangle = 0;  ///< its number: its corners are indices[3 * triangle] and the next two
  glm::dvec3 weights{0};       ///< of its corners, their sum is 1
};

/// Evenly by area: each of `count` equal parts of the area gives a point, so points that follow each other are as near
/// as the triangles are. None where no triangle is finite; where none has an area all are of the last one. O(n).
std::vector<SurfacePoint> points_on(const Surface& surface, std::size_t count, std::uint64_t seed);

/// Where it is.
glm::dvec3 position_of(const Surface& surface, const SurfacePoint& point);

}  // namespace foredraw
