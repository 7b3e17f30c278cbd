#pragma once
// How far the surface that a tessellator shows is from the one that the map of heights describes.

#include <foredraw/base/parallel.h>
#include <foredraw/displaced/height_map.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// A displaced draw of a mesh.
struct HeightPart {
  std::span<const glm::vec3> positions;                 ///< [vertex]
  std::span<const std::uint32_t> indices;               ///< three a triangle
  std::span<const std::array<std::int32_t, 2>> places;  ///< [vertex] height_places()
  foredraw_height_map map{};
  float factor = 1;  ///< how far the map's range moves the surface, in units
};

/// Into how many parts a triangle's edges 0, 1 and 2 are divided, and its inside: 1 to 64.
using WholeLevels = std::array<std::uint8_t, 4>;

inline constexpr std::uint32_t level_count = 7;  ///< 1, 2, 4, ... 64 parts

struct HeightDeviation {
  float squared = 0;  ///< the mean over the triangle times its share in the mesh's area
  float largest = 0;
};

/// Deviations of the triangles of a mesh, all parts together, numbered part by part.
///
/// The deviation at a point of a triangle is the difference of two displacements: the map's there, as
/// foredraw_displaced_height() has it, and the one that is linear between the points of the tessellator's pattern. Both
/// move the same point along nearly the same direction, so it bounds the distance of the surfaces closely. It is taken
/// at the middles of 16 to 4096 equal parts of the triangle, as close as the map's texels where these are no closer.
/// Triangles without a finite area have no share.
class HeightDeviations {
 public:
  /// What is in the parts has to stay.
  HeightDeviations(std::span<const HeightPart> parts, const Executor& executor);

  std::size_t triangles() const { return shares_.size(); }
  std::size_t first_triangle(std::size_t part) const { return begins_[part]; }
  /// What deviations are parts of, in units: the largest factor.
  double unit() const { return unit_; }
  /// [triangle] of the mesh's area, 0 to 1.
  std::span<const float> shares() const { return shares_; }
  /// [triangle] level_for_texels() of the longest edge: no finer level shows much more of the map.
  std::span<const std::uint8_t> finest() const { return finest_; }

  /// Of the same level on all edges and inside, and 0 above the finest level: [triangle][log2 of the level].
  std::vector<std::array<HeightDeviation, level_count>> of_equal_levels() const;
  /// [i] of the triangle `which[i]` at levels[i].
  std::vector<HeightDeviation> of(std::span<const std::uint32_t> which, std::span<const WholeLevels> levels) const;

 private:
  class Heights;
  Heights heights_of(std::size_t triangle) const;
  /// How many parts the samples of the triangle are taken from, along an edge, as a power of two.
  std::uint32_t sampling_of(std::size_t triangle) const;

  std::vector<HeightPart> parts_;
  const Executor& executor_;
  std::vector<std::size_t> begins_;  ///< [part], and the end
  double unit_ = 0;
  std::vector<float> shares_;
  std::vector<std::uint8_t> finest_;
};

/// log2 of the largest power of two, up to 64, of parts between two places that are usual_texels_per_part long.
std::uint8_t level_for_texels(const std::array<std::int32_t, 2>& from, const std::array<std::int32_t, 2>& to);

}  // namespace foredraw
