#pragma once
// A piece of a triangle, as planes cut it.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace foredraw {

/// A flat convex polygon. Its corners are in a fixed place, so pieces are made without memory of their own.
class ConvexPiece {
 public:
  static constexpr std::size_t most_corners = 12;

  ConvexPiece() = default;
  explicit ConvexPiece(std::span<const glm::dvec3> corners) {
    for (const glm::dvec3& corner : corners) add(corner);
  }

  std::span<const glm::dvec3> corners() const { return {corners_.data(), count_}; }
  std::size_t size() const { return count_; }
  void add(const glm::dvec3& corner) { corners_[count_++] = corner; }

  /// The mean of its corners, which is within.
  glm::dvec3 middle() const {
    glm::dvec3 sum(0);
    for (const glm::dvec3& corner : corners()) sum += corner;
    return sum / static_cast<double>(count_);
  }

  /// From one of its two corners that are farthest apart to the other.
  glm::dvec3 longest() const {
    glm::dvec3 result(0);
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = i + 1; j < count_; ++j) {
        const glm::dvec3 way = corners_[j] - corners_[i];
        if (glm::dot(way, way) > glm::dot(result, result)) result = way;
      }
    }
    return result;
  }

  /// How far its farthest corner is from that point.
  double reach_from(const glm::dvec3& point) const {
    double most = 0;
    for (const glm::dvec3& corner : corners()) most = std::max(most, glm::dot(corner - point, corner - point));
    return std::sqrt(most);
  }

  /// Twice the area.
  double area() const {
    glm::dvec3 sum(0);
    for (std::size_t i = 2; i < count_; ++i) {
      sum += glm::cross(corners_[i - 1] - corners_[0], corners_[i] - corners_[0]);
    }
    return glm::length(sum);
  }

 private:
  std::array<glm::dvec3, most_corners> corners_;
  std::size_t count_ = 0;
};

/// Two pieces that make up the whole, with the cut in both. One of them is empty where the plane misses the whole, and
/// where rounding bent it so much that the plane meets it in more than two places.
struct CutPiece {
  ConvexPiece behind, before;
};

/// Cuts a piece that has fewer than most_corners by the plane of the points whose dot product with `normal` is `at`.
/// Corners nearer to it than `slack`, times the normal's length, count as on it.
CutPiece cut(const ConvexPiece& piece, const glm::dvec3& normal, double at, double slack);

}  // namespace foredraw
