#include <foredraw/viewing/bounding_sphere.h>

#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

template <class Visit>
void for_each_drawn(std::span<const DrawnPositions> parts, Visit visit) {
  for (const DrawnPositions& part : parts) {
    for (const std::uint32_t index : part.indices) {
      if (is_finite(part.positions[index])) visit(glm::dvec3(part.positions[index]));
    }
  }
}

}  // namespace

BoundingSphere bounding_sphere(std::span<const DrawnPositions> parts) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  glm::dvec3 least(infinity);
  glm::dvec3 most(-infinity);
  for_each_drawn(parts, [&](const glm::dvec3& position) {
    least = glm::min(least, position);
    most = glm::max(most, position);
  });
  if (least.x > most.x) return {};

  BoundingSphere sphere{(least + most) / 2.0, 0};
  double square = 0;
  for_each_drawn(parts, [&](const glm::dvec3& position) {
    const glm::dvec3 d = position - sphere.centre;
    square = std::max(square, d.x * d.x + d.y * d.y + d.z * d.z);
  });
  sphere.radius = std::sqrt(square);
  return sphere;
}

}  // namespace foredraw
