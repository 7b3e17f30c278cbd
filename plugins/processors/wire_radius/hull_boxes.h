#pragma once
// The hull of points in a plane, and the boxes round it.

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace foredraw::processors::wire_radius {

/// Counter-clockwise, without points on its edges (Andrew 1979). O(n log n). `points` are sorted.
void convex_hull(std::vector<glm::dvec2>& points, std::vector<glm::dvec2>& hull);

/// The same in O(n) of a polygon's corners in their sequence, if it is convex and goes round once; false: it does not.
bool convex_polygon(std::span<const glm::dvec2> corners, bool is_counter_clockwise, std::vector<glm::dvec2>& hull);

/// The box with one side along an edge of the hull. Lengths are from the edge's first corner.
struct HullBox {
  glm::dvec2 along{0};                  ///< of length 1
  double low = 0, high = 0, depth = 0;  ///< along the edge, and square to it
};

/// Boxes at the hull's edges, one after the other: the corners that touch their sides go round with them (Toussaint
/// 1983, rotating calipers). O(n) for all of them.
class HullBoxes {
 public:
  explicit HullBoxes(std::span<const glm::dvec2> hull) : hull_(hull) {}

  /// Edges have to rise from call to call.
  HullBox at(std::size_t edge);

 private:
  double farthest(std::size_t& corner, std::size_t first, const glm::dvec2& from, const glm::dvec2& direction) const;

  std::span<const glm::dvec2> hull_;
  std::size_t high_ = 0, deep_ = 0, low_ = 0;
};

}  // namespace foredraw::processors::wire_radius
