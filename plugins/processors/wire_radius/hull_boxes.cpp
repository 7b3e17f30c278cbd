#include "hull_boxes.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::wiring {

namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

void convex_hull(std::vector<glm::dvec2>& points, std::vector<glm::dvec2>& hull) {
  std::ranges::sort(points,
                    [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  hull.clear();
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const glm::dvec2& point : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
}

HullBox HullBoxes::at(std::size_t edge) {
  const glm::dvec2 from = hull_[edge], to = hull_[(edge + 1) % hull_.size()];
  HullBox box{glm::normalize(to - from)};
  const glm::dvec2 inwards(-box.along.y, box.along.x);
  box.high = farthest(high_, edge + 1, from, box.along);
  box.depth = farthest(deep_, high_, from, inwards);
  box.low = -farthest(low_, deep_, from, -box.along);
  return box;
}

/// On from the corner where it was, and not before `first`, as long as that leads farther along the direction.
double HullBoxes::farthest(std::size_t& corner, std::size_t first, const glm::dvec2& from,
                           const glm::dvec2& direction) const {
  const auto reach = [&](std::size_t i) { return glm::dot(hull_[i % hull_.size()] - from, direction); };
  corner = std::max(corner, first);
  double best = reach(corner);
  for (double next = reach(corner + 1); next > best; next = reach(corner + 1)) {
    best = next;
    ++corner;
  }
  return best;
}

}  // namespace foredraw::wiring
