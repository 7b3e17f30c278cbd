#pragma once
// Which pixels a triangle covers: exactly, in integers.

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

namespace foredraw {

/// A corner in the picture. x to the right and y upwards in 1/256 pixel from the lower left corner, at most 2^20; depth
/// below 2^24.
struct Corner {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::uint32_t depth = 0;
};

inline constexpr std::int32_t subpixels = 256;

/// Twice the area; positive where the corners turn counter-clockwise.
inline std::int64_t doubled_area(const Corner& a, const Corner& b, const Corner& c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

/// Turns the corners counter-clockwise, the least one first. From there on nothing depends on how they were numbered: a
/// triangle drawn twice, from its two sides too, has the same depths and ties. True where they turned clockwise.
inline bool normalise(std::array<Corner, 3>& corners) {
  const bool is_clockwise = doubled_area(corners[0], corners[1], corners[2]) < 0;
  if (is_clockwise) std::swap(corners[1], corners[2]);
  const auto less = [](const Corner& p, const Corner& q) {
    return std::tie(p.x, p.y, p.depth) < std::tie(q.x, q.y, q.depth);
  };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), less), corners.end());
  return is_clockwise;
}

/// The pixels whose centres lie in the box of three corners; empty where last < first.
struct PixelBox {
  std::int32_t first_x, last_x, first_y, last_y;

  PixelBox(const Corner& a, const Corner& b, const Corner& c)
      : first_x(first_centre(std::min({a.x, b.x, c.x}))),
        last_x(last_centre(std::max({a.x, b.x, c.x}))),
        first_y(first_centre(std::min({a.y, b.y, c.y}))),
        last_y(last_centre(std::max({a.y, b.y, c.y}))) {}

  bool is_empty() const { return last_x < first_x || last_y < first_y; }

 private:
  static std::int32_t first_centre(std::int32_t from) { return (from + subpixels / 2 - 1) >> 8; }
  static std::int32_t last_centre(std::int32_t to) { return (to - subpixels / 2) >> 8; }
};

/// numerator / divisor, rounded down, where the numerator grows evenly: divides once and for all.
class EvenQuotient {
 public:
  EvenQuotient(std::int64_t numerator, std::int64_t growth, std::int64_t divisor)
      : divisor_(divisor),
        value_(floor(numerator)),
        rest_(numerator - value_ * divisor),
        step_(floor(growth)),
        rest_step_(growth - step_ * divisor) {}

  std::int64_t value() const { return value_; }

  void step() {
    value_ += step_;
    rest_ += rest_step_;
    if (rest_ < divisor_) return;
    rest_ -= divisor_;
    ++value_;
  }

 private:
  std::int64_t floor(std::int64_t numerator) const { return numerator / divisor_ - (numerator % divisor_ < 0 ? 1 : 0); }

  std::int64_t divisor_, value_, rest_, step_, rest_step_;
};

/// The line through p and q as a function of the pixel: positive to the left of it, and at every centre twice the area
/// of p, q and the centre.
class EdgeFunction {
 public:
  EdgeFunction(const Corner& p, const Corner& q)
      : per_column_(std::int64_t{subpixels} * (p.y - q.y)), per_row_(std::int64_t{subpixels} * (q.x - p.x)) {
    constexpr std::int32_t centre = subpixels / 2;
    at_origin_ = std::int64_t{q.x - p.x} * (centre - p.y) - std::int64_t{q.y - p.y} * (centre - p.x);
    // Of two triangles that share an edge, the one to its right or below owns the centres on it: the top-left rule.
    const bool is_top_or_left = p.y > q.y || (p.y == q.y && p.x > q.x);
    least_inside_ = is_top_or_left ? 0 : 1;
  }

  std::int64_t at(std::int32_t x, std::int32_t y) const { return at_origin_ + x * per_column_ + y * per_row_; }
  std::int64_t per_column() const { return per_column_; }

  std::int64_t per_row() const { return per_row_; }
  bool contains(std::int32_t x, std::int32_t y) const { return at(x, y) >= least_inside_; }

  /// The last column of row y that is inside, of an edge to the right; the last that is not, of one to the left. As the
  /// rows go up.
  EvenQuotient last_column(std::int32_t y) const {
    const std::int64_t above = at(0, y) - least_inside_;
    if (per_column_ < 0) return EvenQuotient(above, per_row_, -per_column_);
    return EvenQuotient(-above - 1, -per_row_, std::max<std::int64_t>(per_column_, 1));
  }

 private:
  std::int64_t per_column_;
  std::int64_t per_row_;
  std::int64_t at_origin_;
  std::int64_t least_inside_;
};

/// A corner's edge is the one across from it.
inline std::array<EdgeFunction, 3> edges_of(const Corner& a, const Corner& b, const Corner& c) {
  return {EdgeFunction(b, c), EdgeFunction(c, a), EdgeFunction(a, b)};
}

/// Calls visit(y, begin, end) for every row of the box of which the counter-clockwise triangle covers [begin, end).
template <class Visit>
void for_each_span(const std::array<EdgeFunction, 3>& edges, PixelBox box, Visit visit) {
  // A horizontal edge leaves out the row that lies on it, or nothing.
  for (const EdgeFunction& edge : edges) {
    if (edge.per_column() != 0) continue;
    while (box.first_y <= box.last_y && !edge.contains(0, box.first_y)) ++box.first_y;
    while (box.first_y <= box.last_y && !edge.contains(0, box.last_y)) --box.last_y;
  }
  const auto last_columns = [&](const EdgeFunction& edge) { return edge.last_column(box.first_y); };
  std::array<EvenQuotient, 3> last = {last_columns(edges[0]), last_columns(edges[1]), last_columns(edges[2])};
  for (std::int32_t y = box.first_y; y <= box.last_y; ++y) {
    std::int64_t begin = box.first_x;
    std::int64_t end = box.last_x + 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if (edges[i].per_column() > 0) begin = std::max(begin, last[i].value() + 1);
      if (edges[i].per_column() < 0) end = std::min(end, last[i].value() + 1);
      last[i].step();
    }
    if (begin < end) visit(y, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end));
  }
}

/// Calls visit(x, y, weights) for every pixel that the counter-clockwise triangle covers, row by row. A corner's weight
/// is the edge function of the edge across from it; the three sum to the doubled area.
template <class Visit>
void for_each_covered(const Corner& a, const Corner& b, const Corner& c, const PixelBox& box, Visit visit) {
  const std::array<EdgeFunction, 3> edges = edges_of(a, b, c);
  for_each_span(edges, box, [&](std::int32_t y, std::int32_t begin, std::int32_t end) {
    std::array<std::int64_t, 3> weights = {edges[0].at(begin, y), edges[1].at(begin, y), edges[2].at(begin, y)};
    for (std::int32_t x = begin; x < end; ++x) {
      visit(x, y, weights);
      for (std::size_t i = 0; i < 3; ++i) weights[i] += edges[i].per_column();
    }
  });
}

}  // namespace foredraw
