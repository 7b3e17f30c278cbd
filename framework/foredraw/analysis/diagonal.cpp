#include <foredraw/analysis/diagonal.h>

#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>

#include <cmath>
#include <limits>

namespace foredraw {

double diagonal_of(std::span<const glm::vec3> positions) {
  glm::dvec3 least(std::numeric_limits<double>::max()), most(-least);
  for (const glm::vec3& p : positions) {
    if (!is_finite(p)) continue;
    least = glm::min(least, glm::dvec3(p));
    most = glm::max(most, glm::dvec3(p));
  }
  const glm::dvec3 box = most - least;
  return box.x >= 0 ? std::sqrt(box.x * box.x + box.y * box.y + box.z * box.z) : 0;
}

}  // namespace foredraw
