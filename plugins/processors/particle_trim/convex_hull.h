#pragma once
// Convex hulls of points on a grid, exactly.

#include <cstdint>
#include <vector>

namespace foredraw::trim {

/// In 1/256 texel from an image's upper left corner, x to the right and y down.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const Point&, const Point&) = default;
};

constexpr Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }

/// Twice the area of the triangle 0, a, b; above 0 where b lies clockwise of a as seen on a screen.
constexpr std::int64_t cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

/// Which the build made out: a monotone chain in 64-bit integers, or CGAL.
std::vector<Point> convex_hull(std::vector<Point> points);

/// The corners of the hull, the least (by x, then y) first, clockwise on a screen (cross() of following edges is above
/// 0); none lies on the line between its neighbours. Fewer than three where the points have no area. Coordinates have to
/// be below 2^30. O(n log n). Source: Andrew 1979, monotone chain.
std::vector<Point> monotone_chain(std::vector<Point> points);

}  // namespace foredraw::trim
