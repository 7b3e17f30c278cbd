#include "dot_rule.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace foredraw {

namespace {

/// Clusters are told apart in so many steps between the rule's zero and its largest value. Those on one flat face,
/// equal but for rounding, so keep their sequence, in which each finds the last one's vertices in the cache.
constexpr int steps = 1024;

/// Sums over the triangles of a cluster or of the mesh.
struct Surface {
  glm::dvec3 moment{0};  ///< centroid times area, all times 6
  glm::dvec3 normal{0};  ///< times 2
  double area = 0;       ///< times 2

  void operator+=(const Surface& other) {
    moment += other.moment;
    normal += other.normal;
    area += other.area;
  }
  glm::dvec3 centroid() const { return moment / (3 * area); }
};

Surface surface_of(const Strided<glm::vec3>& positions, std::span<const std::uint32_t> triangle) {
  const glm::dvec3 a(positions[triangle[0]]), b(positions[triangle[1]]), c(positions[triangle[2]]);
  Surface surface;
  surface.normal = glm::cross(b - a, c - a);
  surface.area = std::sqrt(glm::dot(surface.normal, surface.normal));
  surface.moment = (a + b + c) * surface.area;
  return std::isfinite(surface.area) && surface.area > 0 ? surface : Surface{};
}

}  // namespace

std::vector<std::uint32_t> dot_rule(Strided<glm::vec3> positions, std::span<const std::uint32_t> indices,
                                    const Clusters& clusters) {
  std::vector<Surface> surfaces(clusters.count());
  Surface mesh;
  for (std::size_t c = 0; c < surfaces.size(); ++c) {
    Surface cluster;
    for (std::size_t t = clusters.offsets[c]; t < clusters.offsets[c + 1]; ++t) {
      cluster += surface_of(positions, indices.subspan(3 * t, 3));
    }
    mesh += surfaces[c] = cluster;
  }

  std::vector<double> outwards(surfaces.size(), 0);
  double largest = 0;
  for (std::size_t c = 0; c < surfaces.size(); ++c) {
    const double length = std::sqrt(glm::dot(surfaces[c].normal, surfaces[c].normal));
    if (length <= 0) continue;
    outwards[c] = glm::dot(surfaces[c].centroid() - mesh.centroid(), surfaces[c].normal) / length;
    largest = std::max(largest, std::abs(outwards[c]));
  }

  std::vector<int> rank(surfaces.size(), -steps - 1);
  for (std::size_t c = 0; c < surfaces.size(); ++c) {
    if (surfaces[c].area > 0) rank[c] = largest > 0 ? static_cast<int>(std::round(outwards[c] / largest * steps)) : 0;
  }

  std::vector<std::uint32_t> sequence(surfaces.size());
  std::iota(sequence.begin(), sequence.end(), 0u);
  std::stable_sort(sequence.begin(), sequence.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rank[a] > rank[b]; });
  return sequence;
}

}  // namespace foredraw
