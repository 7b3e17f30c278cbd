#include <foredraw/displaced/smooth_directions.h>

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/displaced/corner_normals.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace foredraw {

namespace {

/// At a position.
struct Sums {
  glm::dvec3 stored{0}, faces{0};
};

glm::vec3 direction_of(const Sums& sums) {
  for (const glm::dvec3& sum : {sums.stored, sums.faces}) {
    const double length = glm::length(sum);
    if (std::isfinite(length) && length > 0) return sum / length;
  }
  return glm::vec3(0);
}

/// `first`: [vertex] of all parts, the first one at the same position.
void add_corners(const DirectedPart& part, std::span<const std::uint32_t> first, std::vector<Sums>& sums) {
  for (std::size_t t = 0; t + 2 < part.indices.size(); t += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t at = part.indices[t + c];
      const glm::dvec3 face = corner_normal(part.positions[at], part.positions[part.indices[t + (c + 1) % 3]],
                                            part.positions[part.indices[t + (c + 2) % 3]]);
      sums[first[at]].faces += face;
      if (part.normals.empty()) continue;
      const glm::dvec3 normal(part.normals[at]);
      const double length = glm::length(normal);
      if (std::isfinite(length) && length > 0) sums[first[at]].stored += glm::length(face) / length * normal;
    }
  }
}

}  // namespace

std::vector<std::vector<glm::vec3>> smooth_directions(std::span<const DirectedPart> parts) {
  std::vector<glm::vec3> positions;
  for (const DirectedPart& part : parts)
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
  const std::vector<std::uint32_t> first = welded(positions);
  std::vector<Sums> sums(positions.size());
  std::size_t begin = 0;
  for (const DirectedPart& part : parts) {
    add_corners(part, std::span(first).subspan(begin, part.positions.size()), sums);
    begin += part.positions.size();
  }
  std::vector<std::vector<glm::vec3>> directions;
  begin = 0;
  for (const DirectedPart& part : parts) {
    auto& of_part = directions.emplace_back();
    for (std::size_t v = 0; v < part.positions.size(); ++v) of_part.push_back(direction_of(sums[first[begin + v]]));
    begin += part.positions.size();
  }
  return directions;
}

}  // namespace foredraw
