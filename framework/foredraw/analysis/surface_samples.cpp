#include <foredraw/analysis/surface_samples.h>

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

std::vector<SurfacePoint> points_on(const Surface& surface, std::size_t count, std::uint64_t seed) {
  std::vector<double> sums;
  std::vector<std::uint32_t> triangles;
  double sum = 0;
  for (std::uint32_t t = 0; t < surface.indices.size() / 3; ++t) {
    const auto corner = [&](std::size_t c) { return glm::dvec3(surface.positions[surface.indices[3 * t + c]]); };
    const double area = glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    if (!std::isfinite(area)) continue;
    sums.push_back(sum += area);
    triangles.push_back(t);
  }
  std::vector<SurfacePoint> points;
  if (triangles.empty()) return points;
  points.reserve(count);
  Random random(seed);
  std::size_t part = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = sum * (static_cast<double>(i) + random.unit()) / static_cast<double>(count);
    while (part + 1 < sums.size() && sums[part] <= at) ++part;
    const double root = std::sqrt(random.unit());
    const double along = random.unit();
    points.push_back({triangles[part], {1 - root, root * (1 - along), root * along}});
  }
  return points;
}

glm::dvec3 position_of(const Surface& surface, const SurfacePoint& point) {
  glm::dvec3 position(0);
  for (int c = 0; c < 3; ++c) {
    const std::uint32_t vertex = surface.indices[std::size_t{3} * point.triangle + static_cast<std::size_t>(c)];
    position += point.weights[c] * glm::dvec3(surface.positions[vertex]);
  }
  return position;
}

}  // namespace foredraw
