#pragma once
// The nearest point of a surface: how far, on which triangle, and where.

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/box_tree.h>
#include <foredraw/scene/vertex_streams.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw {

/// Triangles, three indices each, all below the number of positions. What is not finite is left out.
struct Surface {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;
};

/// The corners of a triangle.
using TriangleCorners = std::array<glm::dvec3, 3>;

inline constexpr std::uint32_t no_triangle = ~std::uint32_t{0};

/// A point of a surface, as the nearest one to a point that was asked for.
struct Closest {
  std::uint32_t triangle = no_triangle;  ///< its number: its corners are indices[3 * triangle] and the next two
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec3 point{0};
  glm::dvec3 weights{0};  ///< of the triangle's corners: 0 to 1, their sum is 1, and `point` is the mean
};

/// The nearest point of one triangle, which may be a line or a point. Numbered 0.
/// After Ericson, Real-Time Collision Detection, section 5.1.5.
Closest closest_on(const TriangleCorners& corners, const glm::dvec3& point);

/// The square of its distance, to the last bit.
double squared_distance(const TriangleCorners& corners, const glm::dvec3& point);

/// Answers which point of a surface, of which it keeps a copy, is the nearest one. O(n log n) to make, some 90 bytes a
/// triangle; of long, thin ones across the axes, which have several boxes, up to 16 times that, but no more than 100 MB
/// beside twice the usual. Near the surface a question takes about a microsecond.
class ClosestPoints {
 public:
  static constexpr std::string_view name = "closest-points";

  explicit ClosestPoints(const Surface& surface);

  /// For a point that is finite; no triangle where the surface has none. Of triangles that are equally near the first
  /// one. `hint`: the number of a triangle that may be near, such as the answer for a point beside this one. It makes
  /// the answer faster, and never another one.
  Closest nearest(const glm::dvec3& point, std::uint32_t hint = no_triangle) const;

  /// The distance, in the unit of the positions; infinite where the surface has no triangle.
  double distance(const glm::dvec3& point) const { return nearest(point).distance; }

  bool empty() const { return nodes_.empty(); }
  /// How many triangles the surface has, those that are not finite too.
  std::size_t size() const { return triangles_.size(); }
  /// Of a triangle that the surface has; of one that is not finite not numbers.
  TriangleCorners corners(std::uint32_t triangle) const;
  /// The greatest absolute coordinate.
  double extent() const { return extent_; }
  /// Of memory.
  std::size_t bytes() const {
    return triangles_.capacity() * sizeof(triangles_[0]) + nodes_.capacity() * sizeof(nodes_[0]);
  }

 private:
  std::vector<std::array<glm::vec3, 3>> triangles_;  ///< in the surface's sequence
  std::vector<BoxTree::Node> nodes_;  ///< around the middle, scaled; the leaf of child c is the triangle first[c]
  double extent_ = 0;
  glm::dvec3 middle_{0};
  double scale_ = 1;  ///< a power of 2 that brings the largest distance from the middle near 1, so that no square of a
                      ///< float is too large
};

/// Of a draw's triangles in its own space, kept by what positions and indices hold.
std::shared_ptr<const ClosestPoints> closest_points_of(Analyses& analyses, const VertexStreams& vertices,
                                                       const Shared<std::uint32_t>& indices);

}  // namespace foredraw
