#pragma once
// The fragments of a part in one view, triangle by triangle: whoever counts or keeps them says what becomes of each.

#include <foredraw/overdraw/corners.h>
#include <foredraw/viewing/camera.h>
#include <foredraw/viewing/raster_part.h>

#include <functional>
#include <vector>

namespace foredraw {

/// Some fragments one after the other, in the order of drawing.
struct Fragments {
  /// Full with so many, where there is room for more: whoever draws looks only now and then.
  static constexpr std::size_t most = 2048;
  static constexpr std::size_t room = most + 17 * 1024;

  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(room);  ///< y * size + x
  std::vector<std::uint32_t> depths = std::vector<std::uint32_t>(room);
  std::vector<std::uint32_t> triangles = std::vector<std::uint32_t>(room);  ///< their numbers
  std::size_t count = 0;
  bool is_row = false;  ///< every pixel is the one to the right of the last: who wants to can be quick then

  bool is_full() const { return count >= most; }

  void add(std::uint32_t pixel, std::uint32_t depth, std::uint32_t triangle) {
    pixels[count] = pixel;
    depths[count] = depth;
    triangles[count++] = triangle;
  }

  void hand_over(const std::function<void(const Fragments&)>& take) {
    take(*this);
    count = 0;
  }
};

using TakeFragments = std::function<void(const Fragments&)>;

/// Draws parts, with memory that is kept from part to part.
class Rasteriser {
 public:
  /// Hands over every fragment of the part in batches, triangle by triangle; but those that its mask discards go to
  /// `take_discarded`, behind the others of their triangle.
  void draw(
      const PreparedPart& part, const Camera& camera, const TakeFragments& take,
      const TakeFragments& take_discarded = [](const Fragments&) {});

 private:
  void draw_whole(const PreparedPart& part, const Camera& camera, const TakeFragments& take);

  Corners corners_;
  std::vector<std::uint32_t> seen_;
  Fragments fragments_;
};

}  // namespace foredraw
