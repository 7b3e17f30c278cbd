#include "convex_hull.h"

#include <algorithm>

namespace foredraw::processors::particle_trim {

std::vector<Point> monotone_chain(std::vector<Point> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto add = [&](const Point& point, std::size_t fixed) {
    while (hull.size() > fixed && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) hull.pop_back();
    hull.push_back(point);
  };
  for (const Point& point : points) add(point, 1);
  const std::size_t there = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], there);
  hull.pop_back();
  return hull;
}

#ifndef FOREDRAW_CGAL_HULL
std::vector<Point> convex_hull(std::vector<Point> points) { return monotone_chain(std::move(points)); }
#endif

}  // namespace foredraw::processors::particle_trim
