#include "discontinuity_term.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace foredraw::processors::energy_collapse {

OnEdge nearest_on_edge(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& point) {
  const glm::dvec3 edge = to - from;
  const double length = glm::dot(edge, edge);
  const double along = length > 0 ? std::clamp(glm::dot(point - from, edge) / length, 0.0, 1.0) : 0.0;
  const glm::dvec3 off = from + along * edge - point;
  return {glm::dot(off, off), along};
}

double discontinuity_term(const Star& star, const glm::dvec3& place, double weight, std::vector<Nearest>& nearest,
                          Fit& fit) {
  nearest.resize(star.curve_at.size());
  double sum = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    Nearest best;
    best.squared = std::numeric_limits<double>::infinity();
    for (std::uint32_t c = 0; c < star.curve_end_at.size(); ++c) {
      const OnEdge on = nearest_on_edge(place, star.curve_end_at[c], star.curve_at[i]);
      if (on.squared < best.squared) best = {c, {1 - on.along, on.along, 0}, on.squared};
    }
    if (star.curve_end_at.empty()) {
      const glm::dvec3 off = place - star.curve_at[i];
      best = {0, {1, 0, 0}, glm::dot(off, off)};
    }
    const glm::dvec3 rest =
        star.curve_end_at.empty() ? glm::dvec3(0) : best.weights.y * star.curve_end_at[best.triangle];
    fit.add(weight, best.weights.x, star.curve_at[i] - rest);
    sum += best.squared;
    nearest[i] = best;
  }
  return weight * sum;
}

bool CurveRules::is_sharp(std::uint32_t p, std::uint32_t q) const {
  std::size_t count = 0;
  std::array<std::uint32_t, 2> first{};
  bool is_alike = true;
  for (const std::uint32_t t : recorder_.triangles_at(p)) {
    const CollapseRecorder::Corners& points = recorder_.points()[t];
    const auto at = [&](std::uint32_t point) {
      return recorder_.vertices()[t][static_cast<std::size_t>(std::ranges::find(points, point) - points.begin())];
    };
    if (std::ranges::find(points, q) == points.end()) continue;
    const std::array<std::uint32_t, 2> vertices{at(p), at(q)};
    if (count++ == 0) first = vertices;
    is_alike = is_alike && first == vertices;
  }
  return count != 2 || !is_alike;
}

std::vector<std::uint32_t> CurveRules::sharp_neighbours(std::uint32_t p) const {
  std::vector<std::uint32_t> seen, sharp;
  for (const std::uint32_t t : recorder_.triangles_at(p)) {
    for (const std::uint32_t q : recorder_.points()[t]) {
      if (q == p || std::ranges::find(seen, q) != seen.end()) continue;
      seen.push_back(q);
      if (is_sharp(p, q)) sharp.push_back(q);
    }
  }
  return sharp;
}

bool CurveRules::keeps_curves(std::uint32_t p, std::uint32_t q) const {
  const std::vector<std::uint32_t> of_p = sharp_neighbours(p), of_q = sharp_neighbours(q);
  if (of_p.empty() || of_q.empty()) return true;
  if (std::ranges::find(of_p, q) == of_p.end()) return false;
  if (of_p.size() != 2 && of_q.size() != 2) return false;
  return std::ranges::none_of(of_p, [&](std::uint32_t one) { return std::ranges::find(of_q, one) != of_q.end(); });
}

}  // namespace foredraw::processors::energy_collapse
