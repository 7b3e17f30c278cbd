#include "direction_gap.h"

#include <foredraw/analysis/welded_positions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foredraw {

namespace {

constexpr double degrees_of_radian = 57.295779513082321;
constexpr double rounding = 1e-6;  // of a unit vector of floats

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return degrees_of_radian * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// What the vertices at a position have.
struct AtPosition {
  std::size_t vertices = 0;
  glm::dvec3 normal{0};  ///< of the first one
  bool is_split = false;
  double largest = 0;
};

}  // namespace

DirectionGap direction_gap(std::span<const DirectedPart> parts) {
  std::vector<glm::vec3> positions;
  for (const DirectedPart& part : parts)
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
  const std::vector<std::uint32_t> first = welded(positions);
  const std::vector<std::vector<glm::vec3>> directions = smooth_directions(parts);
  std::vector<AtPosition> at(positions.size());
  std::size_t vertex = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (std::size_t v = 0; v < parts[p].positions.size(); ++v, ++vertex) {
      if (parts[p].normals.empty()) continue;
      const glm::dvec3 stored(parts[p].normals[v]);
      const double length = glm::length(stored);
      if (!std::isfinite(length) || length == 0) continue;
      const glm::dvec3 normal = stored / length;
      AtPosition& of = at[first[vertex]];
      if (of.vertices++ == 0) of.normal = normal;
      of.is_split = of.is_split || glm::length(normal - of.normal) > rounding;
      of.largest = std::max(of.largest, angle(normal, glm::dvec3(directions[p][v])));
    }
  }
  DirectionGap gap;
  for (const AtPosition& of : at) {
    if (of.vertices < 2) continue;
    ++gap.shared;
    if (!of.is_split) continue;
    ++gap.split;
    gap.largest = std::max(gap.largest, of.largest);
  }
  return gap;
}

}  // namespace foredraw
