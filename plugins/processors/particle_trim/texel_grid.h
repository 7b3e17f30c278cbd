#pragma once
// Where something lies in an image, on a grid of 1/256 texel.

#include <compare>
#include <cstdint>

namespace foredraw::processors::particle_trim {

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

/// Upright, in steps of 1/256 texel.
struct Box {
  Point least, most;

  double area() const { return static_cast<double>(most.x - least.x) * static_cast<double>(most.y - least.y); }
};

}  // namespace foredraw::processors::particle_trim
