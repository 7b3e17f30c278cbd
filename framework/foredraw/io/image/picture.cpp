#include <foredraw/io/image/picture.h>
#include <foredraw/io/image/private/encode.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
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

void Picture::blend(int x, int y, Colour colour, float part) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  std::uint8_t* texel =
      &rgb_[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x))];
  const std::uint8_t channels[] = {colour.red, colour.green, colour.blue};
  for (int c = 0; c < 3; ++c) {
    const float was = texel[c];
    texel[c] = static_cast<std::uint8_t>(was + (static_cast<float>(channels[c]) - was) * part + 0.5f);
  }
}

void Picture::line(glm::vec2 from, glm::vec2 to, float width, Colour colour, float part) {
  const float reach = width / 2 + 0.5f;
  const glm::vec2 least = glm::min(from, to) - reach, most = glm::max(from, to) + reach;
  const glm::vec2 along = to - from;
  const float length = glm::dot(along, along);
  const int right = std::min(static_cast<int>(std::ceil(most.x)), width_);
  const int bottom = std::min(static_cast<int>(std::ceil(most.y)), height_);
  for (int y = std::max(static_cast<int>(std::floor(least.y)), 0); y < bottom; ++y) {
    for (int x = std::max(static_cast<int>(std::floor(least.x)), 0); x < right; ++x) {
      const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float at = length > 0 ? std::clamp(glm::dot(centre - from, along) / length, 0.0f, 1.0f) : 0;
      const glm::vec2 off = centre - from - along * at;
      const float covered = std::clamp(reach - std::sqrt(glm::dot(off, off)), 0.0f, 1.0f);
      if (covered > 0) blend(x, y, colour, covered * part);
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

std::vector<std::byte> Picture::as_png() const { return png_of(width_, height_, 3, rgb_.data()); }

std::vector<std::byte> png_of_pixels(int width, int height, std::span<const std::uint8_t> rgb) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width < 1 || height < 1 || rgb.size() != 3 * pixels)
    throw std::invalid_argument("the pixels do not fill the picture");
  std::vector<std::uint8_t> grey(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* pixel = &rgb[3 * i];
    if (pixel[0] != pixel[1] || pixel[1] != pixel[2]) return png_of(width, height, 3, rgb.data());
    grey[i] = pixel[0];
  }
  return png_of(width, height, 1, grey.data());
}

}  // namespace foredraw::images
