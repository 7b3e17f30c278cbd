#include <foredraw/displaced/corner_normals.h>

#include <foredraw/geometry/finite.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

namespace foredraw {

glm::dvec3 corner_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::dvec3 to_b = glm::dvec3(b) - glm::dvec3(a), to_c = glm::dvec3(c) - glm::dvec3(a);
  const glm::dvec3 normal = glm::cross(to_b, to_c) / (glm::dot(to_b, to_b) * glm::dot(to_c, to_c));
  return is_finite(normal) ? normal : glm::dvec3(0);
}

void replace_by_face_normals(std::span<glm::vec3> normals, std::span<const glm::vec3> positions,
                             std::span<const std::uint32_t> indices, std::span<const std::uint32_t> groups) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0));
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t at = indices[t + c];
      sums[groups[at]] +=
          corner_normal(positions[at], positions[indices[t + (c + 1) % 3]], positions[indices[t + (c + 2) % 3]]);
    }
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const glm::dvec3& sum = sums[groups[v]];
    const double length = glm::length(sum);
    if (std::isfinite(length) && length > 0) normals[v] = sum / length;
  }
}

}  // namespace foredraw
