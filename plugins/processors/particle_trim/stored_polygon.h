#pragma once
// Polygons as they are stored, and the proof that they hold what they should.

#include "footprint.h"
#include "uv_grid.h"

#include <glm/vec2.hpp>

#include <optional>
#include <span>

namespace foredraw::processors::particle_trim {

/// A convex polygon whose corners are texture coordinates that a format can hold.
class StoredPolygon {
 public:
  /// Round the corners (in steps from the image's upper left corner, in the direction of a hull), larger by no more
  /// than what rounding asks for. None where they have no area.
  static std::optional<StoredPolygon> round(std::span<const glm::dvec2> corners, const AlphaImage& image,
                                            UvFormat format);

  /// Whether the point, in steps, lies inside or on an edge; in whole numbers, so there is no error.
  bool holds(const Point& point) const;

  /// In texels of the image.
  double area() const;
  std::vector<glm::dvec2> texture_coordinates() const;
  /// In steps from the image's upper left corner.
  std::vector<glm::dvec2> places() const;

 private:
  StoredPolygon(std::vector<Point> corners, const AlphaImage& image, UvGrid grid)
      : corners_(std::move(corners)), width_(image.width), height_(image.height), grid_(grid) {}

  std::vector<Point> corners_;  ///< in parts of the grid
  std::int64_t width_, height_;
  UvGrid grid_;
};

}  // namespace foredraw::processors::particle_trim
