#include <foredraw/io/private/picture.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
// After the other: it wants what that includes.
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace foredraw::images {

namespace {

/// The font looks letters up by number, and has those of ASCII alone. It takes no const.
std::string in_letters_of_the_font(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

}  // namespace

Picture::Picture(int width, int height, Colour background) : width_(width), height_(height) {
  rgb_.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  fill(0, 0, width, height, background);
}

void Picture::fill(int x, int y, int width, int height, Colour colour) {
  const int right = std::min(x + width, width_);
  const int bottom = std::min(y + height, height_);
  for (int row = std::max(y, 0); row < bottom; ++row) {
    for (int column = std::max(x, 0); column < right; ++column) {
      std::uint8_t* texel = &rgb_[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                       static_cast<std::size_t>(column))];
      texel[0] = colour.red;
      texel[1] = colour.green;
      texel[2] = colour.blue;
    }
  }
}

void Picture::write(int x, int y, const std::string& text, Colour colour, int scale) {
  struct Corner {
    float x, y, z;
    std::uint8_t rgba[4];
  };
  using Box = std::array<Corner, 4>;             // upright, from the upper left corner on, clockwise
  std::vector<Box> boxes(20 * text.size() + 1);  // the font's letters have 7 boxes in the mean
  std::string letters = in_letters_of_the_font(text);
  const int count =
      stb_easy_font_print(0, 0, letters.data(), nullptr, boxes.data(), static_cast<int>(boxes.size() * sizeof(Box)));
  for (const Box& box : std::span(boxes).first(static_cast<std::size_t>(count))) {
    const auto scaled = [scale](float length) { return static_cast<int>(length) * scale; };
    fill(x + scaled(box[0].x), y + scaled(box[0].y), scaled(box[2].x - box[0].x), scaled(box[2].y - box[0].y), colour);
  }
}

int Picture::width_of(const std::string& text, int scale) {
  std::string letters = in_letters_of_the_font(text);
  return stb_easy_font_width(letters.data()) * scale;
}

std::vector<std::byte> Picture::as_png() const {
  std::vector<std::byte> png;
  const auto append = [](void* to, void* bytes, int count) {
    const auto* first = static_cast<const std::byte*>(bytes);
    static_cast<std::vector<std::byte>*>(to)->insert(static_cast<std::vector<std::byte>*>(to)->end(), first,
                                                     first + count);
  };
  if (stbi_write_png_to_func(append, &png, width_, height_, 3, rgb_.data(), 3 * width_) == 0) {
    throw std::runtime_error("the picture can not be encoded");
  }
  return png;
}

}  // namespace foredraw::images
