#include "distance_term.h"

#include <foredraw/analysis/closest_points.h>
#include <foredraw/geometry/box.h>

#include <algorithm>
#include <limits>

namespace foredraw::processors::energy_collapse {

namespace {

constexpr double nothing = 1e-30;  // a squared distance in box diagonals that is rounding

using PlaceBox = Box<glm::dvec3>;

PlaceBox box_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  PlaceBox box;
  for (const glm::dvec3& corner : {a, b, c}) box.add(corner);
  return box;
}

double squared_distance_of(const PlaceBox& box, const glm::dvec3& point) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double off = std::max({box.min[k] - point[k], point[k] - box.max[k], 0.0});
    sum += off * off;
  }
  return sum;
}

}  // namespace

double distance_term(const Star& star, const glm::dvec3& place, double weight, std::vector<Nearest>& nearest,
                     Fit& fit) {
  std::vector<PlaceBox> boxes;
  boxes.reserve(star.triangles.size());
  for (const StarTriangle& triangle : star.triangles) {
    boxes.push_back(box_of(place, triangle.others[0], triangle.others[1]));
  }
  nearest.resize(star.sample_at.size());
  double sum = 0;
  std::uint32_t first = 0;  // what was nearest to the sample before, which is often near
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const glm::dvec3& at = star.sample_at[i];
    Nearest best;
    best.squared = std::numeric_limits<double>::infinity();
    const auto look_at = [&](std::uint32_t t) {
      const auto& [a, b] = star.triangles[t].others;
      const Closest closest = closest_on({place, a, b}, at);
      const double squared = closest.distance * closest.distance;
      if (squared < best.squared) best = {t, closest.weights, squared};
    };
    look_at(first);
    for (std::uint32_t t = 0; t < boxes.size() && best.squared > nothing; ++t) {
      if (t != first && squared_distance_of(boxes[t], at) < best.squared) look_at(t);
    }
    first = best.triangle;
    const auto& [a, b] = star.triangles[best.triangle].others;
    fit.add(weight, best.weights.x, at - best.weights.y * a - best.weights.z * b);
    sum += best.squared;
    nearest[i] = best;
  }
  return weight * sum;
}

double overshoot_term(const Star& star, const glm::dvec3& place, double weight, double squared, double spacing) {
  constexpr double slack = 9;  // three times as far
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& at : star.sample_at) {
    const glm::dvec3 off = at - place;
    least = std::min(least, off.x * off.x + off.y * off.y + off.z * off.z);
  }
  if (star.sample_at.empty()) return 0;
  const double points = static_cast<double>(star.sample_at.size()) / static_cast<double>(star.triangles.size());
  return weight * points * std::max(0.0, least - slack * squared - spacing * spacing);
}

}  // namespace foredraw::processors::energy_collapse
