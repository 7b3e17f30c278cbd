#pragma once
#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foredraw::images {

struct Colour {
  std::uint8_t red, green, blue;
};

/// Rows from the top.
class Picture {
 public:
  Picture(int width, int height, Colour background);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Fills what of the box is inside of the picture.
  void fill(int x, int y, int width, int height, Colour colour);

  /// Lays a colour over one pixel, as much of it as `part` says (0 to 1). Nothing where it is outside.
  void blend(int x, int y, Colour colour, float part);

  /// A line with round ends and smooth edges. Places are in pixels, (0, 0) is the upper left corner of the first one; a
  /// line from a place to itself is a dot.
  void line(glm::vec2 from, glm::vec2 to, float width, Colour colour, float part = 1);

  /// ASCII, `scale` times 12 pixels high, from its upper left corner.
  void write(int x, int y, const std::string& text, Colour colour, int scale = 1);

  /// Width of the text in pixels.
  static int width_of(const std::string& text, int scale = 1);

  std::vector<std::byte> as_png() const;

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> rgb_;
};

/// A PNG of red, green and blue for each pixel, rows from the top; of one channel where every pixel is grey. `rgb`
/// holds 3 * width * height bytes, else std::invalid_argument.
std::vector<std::byte> png_of_pixels(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace foredraw::images
