#pragma once
// Images as others take them. Private to io.

#include <foredraw/scene/image.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace foredraw::images {

/// Rows from the top, 1 to 4 channels of 8 bits.
std::vector<std::byte> png_of(int width, int height, int channels, const std::uint8_t* rows);

/// Red, green, blue, alpha: 8 bits each, not multiplied with alpha. Of floats, what is from 0 to 1, by a gamma of 2.
struct Rgba {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;
};

/// Or why not, in words that go on from the image's name.
std::variant<Rgba, std::string> rgba_of(const Image& image);

/// PNG and JPEG as they are, TGA as PNG, OpenEXR as a PNG of 8 bits, which is but a preview.
std::variant<Image, std::string> png_or_jpeg(const Image& image);

/// "data:image/png;base64,..."
std::string data_uri(const Image& image);

}  // namespace foredraw::images
