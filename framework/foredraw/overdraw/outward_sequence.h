#pragma once
// The DotRule: what faces outwards is drawn first, for it hides other parts and is hidden by few.
// Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and Reduced Overdraw, SIGGRAPH 2007, "The
// DotRule".

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace foredraw {

/// Sums over triangles.
struct SurfaceSum {
  glm::dvec3 moment{0};  ///< centroid times area, all times 6
  glm::dvec3 normal{0};  ///< times 2
  double area = 0;       ///< times 2

  void operator+=(const SurfaceSum& other) {
    moment += other.moment;
    normal += other.normal;
    area += other.area;
  }
  /// Nothing of a triangle that is not finite.
  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    SurfaceSum one;
    one.normal = glm::cross(b - a, c - a);
    one.area = std::sqrt(glm::dot(one.normal, one.normal));
    one.moment = (a + b + c) * one.area;
    if (std::isfinite(one.area) && one.area > 0) *this += one;
  }
  glm::dvec3 centroid() const { return moment / (3 * area); }
};

/// The sequence of parts ([new] = old) by falling (centroid of the part - centroid of `whole`) . (unit normal of the
/// part). Those that are equal to 1/1024 of the largest value, as on one flat face, keep their sequence; what has no
/// area goes last.
inline std::vector<std::uint32_t> outward_sequence(std::span<const SurfaceSum> parts, const SurfaceSum& whole) {
  constexpr int steps = 1024;
  std::vector<double> outwards(parts.size(), 0);
  double largest = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const double length = std::sqrt(glm::dot(parts[p].normal, parts[p].normal));
    if (length <= 0) continue;
    outwards[p] = glm::dot(parts[p].centroid() - whole.centroid(), parts[p].normal) / length;
    largest = std::max(largest, std::abs(outwards[p]));
  }
  std::vector<int> rank(parts.size(), -steps - 1);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].area > 0) rank[p] = largest > 0 ? static_cast<int>(std::round(outwards[p] / largest * steps)) : 0;
  }
  std::vector<std::uint32_t> sequence(parts.size());
  std::iota(sequence.begin(), sequence.end(), 0u);
  std::stable_sort(sequence.begin(), sequence.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rank[a] > rank[b]; });
  return sequence;
}

}  // namespace foredraw
