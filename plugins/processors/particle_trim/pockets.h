#pragma once
// What a polygon round a hull covers besides the hull. Between two of its edges that lie on edges of the hull it runs
// along their lines to where these meet, or along one more edge that only touches the hull: the pocket between.

#include "convex_hull.h"

#include <glm/vec2.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace foredraw::processors::particle_trim {

/// Whether a polygon may cover this triangle, which lies beside the hull.
using Allowed = std::function<bool(const glm::dvec2&, const glm::dvec2&, const glm::dvec2&)>;

class Pockets {
 public:
  /// `hull` as convex_hull() makes it, of three corners or more; it has to stay. Edge i goes from corner i to the next.
  Pockets(std::span<const Point> hull, Allowed allowed);

  std::size_t edges() const { return hull_.size(); }
  double hull_area() const { return 0.5 * static_cast<double>(sums_[hull_.size()]); }

  /// The area between the lines of edge i and the `steps`-th edge behind it; infinity where they turn by half a circle
  /// or more. It grows with the steps. Its error is below 1e-15 of what the lines enclose.
  double area(std::size_t i, std::size_t steps) const;

  /// Whether that may be covered.
  bool is_allowed(std::size_t i, std::size_t steps) const;

  /// The area between the lines of two edges, or infinity where it may not be covered.
  double between(std::size_t from, std::size_t to) const;
  std::size_t steps(std::size_t from, std::size_t to) const { return (to + edges() - from) % edges(); }

  /// Where these lines meet.
  glm::dvec2 corner(std::size_t i, std::size_t steps) const;

  /// An edge that only touches the hull, between two that lie on it.
  struct Free {
    double area = 0;  ///< of the pocket
    glm::dvec2 from, touching, to;
  };
  /// The one that makes the pocket smallest; it touches the hull at its midpoint. None where an edge on the hull makes
  /// it as small: always where the lines turn by half a circle or less. Where they turn by more, the area grows with
  /// the steps. (DePano 1987, "Polygon approximation with optimized polygonal enclosures"; Aggarwal, Chang and Yap
  /// 1985.)
  std::optional<Free> free(std::size_t i, std::size_t steps) const;

  bool is_allowed(std::size_t i, std::size_t steps, const Free& free) const;

 private:
  const Point& at(std::size_t i) const { return hull_[i % hull_.size()]; }
  Point direction(std::size_t i) const { return at(i + 1) - at(i); }
  std::int64_t chain(std::size_t i, std::size_t steps) const;
  bool is_growing(std::size_t edge, const Point& pivot, std::size_t i, std::size_t j) const;

  std::span<const Point> hull_;
  Allowed allowed_;
  std::vector<std::int64_t> sums_;  ///< [i] = of cross() of the corners before i with the next
};

}  // namespace foredraw::processors::particle_trim
