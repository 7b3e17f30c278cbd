#include "hull_boxes.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::processors::wire_radius {

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

bool convex_polygon(std::span<const glm::dvec2> corners, bool is_counter_clockwise, std::vector<glm::dvec2>& hull) {
  const auto is_before = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  const auto first = static_cast<std::size_t>(std::ranges::min_element(corners, is_before) - corners.begin());
  const std::size_t count = corners.size();
  hull.clear();
  bool comes_back = false;
  const auto add = [&](const glm::dvec2& point) {
    while (hull.size() >= 2) {
      const double bend = turn(hull[hull.size() - 2], hull.back(), point);
      if (bend < 0) return false;
      if (bend > 0) break;
      hull.pop_back();  // on the edge, or the same point
    }
    // From its first corner it goes to the last one, and back: once.
    if (!hull.empty() && point.x < hull.back().x) comes_back = true;
    if (!hull.empty() && point.x > hull.back().x && comes_back) return false;
    hull.push_back(point);
    return true;
  };
  for (std::size_t i = 0; i <= count; ++i) {
    const std::size_t at = first + (is_counter_clockwise ? i : count - i);
    if (!add(corners[at < count ? at : at - count])) return false;
  }
  hull.pop_back();
  return hull.size() >= 3 && turn(hull.back(), hull[0], hull[1]) > 0;
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
  corner = std::max(corner, first);
  std::size_t place = corner % hull_.size();
  double best = glm::dot(hull_[place] - from, direction);
  for (;;) {
    place = place + 1 < hull_.size() ? place + 1 : 0;
    const double next = glm::dot(hull_[place] - from, direction);
    if (!(next > best)) return best;
    best = next;
    ++corner;
  }
}

}  // namespace foredraw::processors::wire_radius
