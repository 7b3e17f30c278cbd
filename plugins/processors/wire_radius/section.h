#pragma once
// Where a plane cuts a surface: a loop, or a line from one border to another.

#include "welded_mesh.h"

#include <glm/vec2.hpp>

namespace foredraw::processors::wire_radius {

struct Plane {
  glm::dvec3 at;
  glm::dvec3 normal;  ///< of length 1
  double height(const glm::dvec3& point) const;
};

/// Half widths are those of the outline's hull, so a dent does not count.
struct Section {
  bool closed = false;
  glm::dvec3 centre{0};            ///< of a loop: of its area; else of the least box round it
  double least = 0, greatest = 0;  ///< half widths across, of the hull
  glm::dvec3 across{0};            ///< the direction of the greatest, of length 1
  glm::dvec3 opening{0};           ///< of an open one that is not flat: to where it has no wall, of length 1
  double perimeter = 0;
  double roundness = 0;  ///< of a loop: 4 pi area / perimeter^2; 1 is a circle, .785 a square

  /// A line, or nearly one: what stands here has no thickness.
  bool is_flat() const { return !closed && least < 0.2 * greatest; }
  /// What is to be held against a pixel: half the least width, of a flat one half its breadth.
  double half_width() const { return is_flat() ? greatest : least; }
  double mean_half_width() const { return is_flat() ? greatest : (least + greatest) / 2; }
};

/// Cuts a surface. It keeps its buffers from one cut to the next.
class Cutter {
 public:
  explicit Cutter(const WeldedMesh& mesh) : mesh_(mesh) {}

  /// The section through this triangle. False where the plane does not cross it, or it takes more than `most_steps`
  /// triangles or a greater perimeter than `most_perimeter`: then triangles() are those that it went through by then.
  bool cut(std::uint32_t triangle, const Plane& plane, std::size_t most_steps, double most_perimeter);

  /// Of the last cut; widths are measured when it is asked for.
  const Section& section();
  /// Of the last cut, as section() has them, but without measuring widths where that can be helped.
  glm::dvec3 centre();
  double perimeter() const { return section_.perimeter; }
  bool is_closed() const { return section_.closed; }
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }

  /// Whether the plane has corners of the triangle on both sides; one in the plane counts as above it.
  bool crosses(std::uint32_t triangle, const Plane& plane) const;

  /// From triangle to triangle towards the plane, until one crosses it; none where the way ends before.
  std::uint32_t walk(std::uint32_t triangle, const Plane& plane, std::size_t most_steps) const;

  /// The direction that the triangles of the last cut have in common: the one most square to their normals, near that
  /// of the plane; or, where it is open, the one between its borders'.
  glm::dvec3 axis(const Plane& plane) const;

  /// How far above the plane the lowest corner lies of those that the last cut's triangles have above it.
  double next_corner(const Plane& plane) const;

 private:
  bool trace(std::uint32_t triangle, std::uint32_t edge, const Plane& plane, double most_perimeter,
             std::size_t most_steps, std::vector<glm::dvec3>& outline, bool& closed);
  void measure_line(const Plane& plane);
  void measure_widths();
  glm::dvec3 in_space(const glm::dvec2& at) const { return at_ + at.x * across_[0] + at.y * across_[1]; }

  const WeldedMesh& mesh_;
  Section section_;
  std::vector<std::uint32_t> triangles_;
  std::vector<glm::dvec3> outline_, backwards_;
  std::vector<glm::dvec2> flat_, hull_;
  // Of the last cut, in its plane: a place, two directions, the outline's area, and middles times area and length.
  glm::dvec3 at_{0}, across_[2];
  glm::dvec2 middle_{0}, of_line_{0};
  double area_ = 0;
  bool has_widths_ = false;
  glm::dvec3 borders_{0};  ///< the sum of their directions where the last cut ends, upwards
};

}  // namespace foredraw::processors::wire_radius
