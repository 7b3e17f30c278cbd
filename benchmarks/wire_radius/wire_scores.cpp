#include "wire_scores.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace foredraw::bench {

void WireScore::add(const WireScore& other) {
  known += other.known;
  reached += other.reached;
  found += other.found;
  right += other.right;
  either += other.either;
  centre_error.insert(centre_error.end(), other.centre_error.begin(), other.centre_error.end());
  radius_error.insert(radius_error.end(), other.radius_error.begin(), other.radius_error.end());
}

WireScore score(const KnownMesh& known, const FoundWires& found) {
  WireScore result;
  std::vector<double> area(known.length.size(), 0), covered(known.length.size(), 0);
  struct Parts {
    double wire = 0, none = 0, either = 0;
  };
  std::vector<Parts> parts(found.wires.size());
  for (std::size_t t = 0; t < known.wire_of.size(); ++t) {
    const auto corner = [&](std::size_t i) { return glm::dvec3(known.positions[known.indices[3 * t + i]]); };
    const double size = glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
    const std::uint32_t is = known.wire_of[t], as = found.wire_of[t];
    if (is < either_way) {
      area[is] += size;
      if (as != FoundWires::none) covered[is] += size;
    }
    if (as != FoundWires::none)
      (is == no_wire ? parts[as].none : is == either_way ? parts[as].either : parts[as].wire) += size;
  }
  for (std::size_t w = 0; w < area.size(); ++w) {
    result.known += known.length[w];
    if (area[w] > 0) result.reached += known.length[w] * covered[w] / area[w];
  }
  for (std::size_t w = 0; w < parts.size(); ++w) {
    const double all = parts[w].wire + parts[w].none + parts[w].either;
    if (!(all > 0)) continue;
    result.found += found.wires[w].length * (parts[w].wire + parts[w].none) / all;
    result.right += found.wires[w].length * parts[w].wire / all;
    result.either += found.wires[w].length * parts[w].either / all;
  }
  for (std::size_t v = 0; v < known.half_width.size(); ++v) {
    if (!(known.half_width[v] > 0) || !(found.half_width[v] > 0)) continue;
    const glm::dvec3 centre = glm::dvec3(known.positions[v]) + glm::dvec3(found.to_centre[v]);
    result.centre_error.push_back(glm::distance(centre, known.centre[v]) / known.half_width[v]);
    result.radius_error.push_back(std::abs(found.half_width[v] / known.half_width[v] - 1));
  }
  return result;
}

}  // namespace foredraw::bench
