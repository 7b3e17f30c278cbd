#pragma once
// The fragments of a part in one view, triangle by triangle: whoever counts or keeps them says what becomes of each.

#include <foredraw/analysis/camera.h>
#include <foredraw/analysis/corners.h>
#include <foredraw/analysis/raster_part.h>

#include <functional>
#include <span>
#include <vector>

namespace foredraw {

/// Some fragments one after the other, in the order of drawing.
struct Fragments {
  static constexpr std::size_t most = 2048;  ///< a batch is full; what the last triangle adds still has room
  static constexpr std::size_t room = most + 2048;

  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(room);     ///< y * size + x
  std::vector<std::uint32_t> depths = std::vector<std::uint32_t>(room);
  std::vector<std::uint32_t> triangles = std::vector<std::uint32_t>(room);  ///< their numbers
  std::size_t count = 0;
};

/// Draws parts, with memory that is kept from part to part.
class Rasteriser {
 public:
  /// Hands over every fragment of the part in batches, triangle by triangle.
  void draw(const PreparedPart& part, const Camera& camera, const std::function<void(const Fragments&)>& take);

 private:
  Corners corners_;
  std::vector<std::uint32_t> seen_;
  Fragments fragments_;
};

}  // namespace foredraw
