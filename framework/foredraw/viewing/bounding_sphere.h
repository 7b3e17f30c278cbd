#pragma once
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace foredraw {

/// Radius 0 where there is a single point, or none (then at the origin).
struct BoundingSphere {
  glm::dvec3 centre{0};
  double radius = 0;
};

/// Positions that are drawn: those of `indices`, of which only finite ones count.
struct DrawnPositions {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;
};

/// The sphere that views of a subject are framed by: around the middle of the axis-aligned box of everything drawn, out
/// to the farthest position. Not the smallest, but the same on every machine and blind to the order of triangles.
BoundingSphere bounding_sphere(std::span<const DrawnPositions> parts);

}  // namespace foredraw
