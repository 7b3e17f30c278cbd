#include <foredraw/io/image/images.h>
#include <foredraw/io/image/private/encode.h>
#include <foredraw/io/image/private/headers.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace foredraw::images {

namespace {

std::variant<Texels, std::string> texels_of(const Image& image) {
  if (!image.uri.empty()) return "is in a separate file, '" + image.uri + "'";
  if (image.is_texels) return Texels{*image.facts, {image.bytes.view().begin(), image.bytes.view().end()}};
  Diagnostics diagnostics;
  auto texels = decode_image(image.bytes.view(), {}, diagnostics);
  if (!texels) return diagnostics.all().front().message;
  return std::move(*texels);
}

std::uint8_t eight_bits(const std::byte* at, int bits) {
  if (bits == 8) return std::to_integer<std::uint8_t>(*at);
  if (bits == 16) {
    std::uint16_t value;
    std::memcpy(&value, at, sizeof(value));
    return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
  }
  float value;
  std::memcpy(&value, at, sizeof(value));
  return value > 0 ? static_cast<std::uint8_t>(std::sqrt(std::min(value, 1.0f)) * 255 + 0.5f) : std::uint8_t{0};
}

/// Alpha is no light, and has no gamma.
std::uint8_t eight_bits_of_alpha(const std::byte* at, int bits) {
  if (bits != 32) return eight_bits(at, bits);
  float value;
  std::memcpy(&value, at, sizeof(value));
  return value > 0 ? static_cast<std::uint8_t>(std::min(value, 1.0f) * 255 + 0.5f) : std::uint8_t{0};
}

}  // namespace

std::vector<std::byte> png_of(int width, int height, int channels, const std::uint8_t* rows) {
  std::vector<std::byte> png;
  const auto append = [](void* to, void* bytes, int count) {
    auto* all = static_cast<std::vector<std::byte>*>(to);
    const auto* first = static_cast<const std::byte*>(bytes);
    all->insert(all->end(), first, first + count);
  };
  if (stbi_write_png_to_func(append, &png, width, height, channels, rows, channels * width) == 0) {
    throw std::runtime_error("the picture cannot be encoded");
  }
  return png;
}

std::variant<Rgba, std::string> rgba_of(const Image& image) {
  auto made = texels_of(image);
  if (std::string* why = std::get_if<std::string>(&made)) return std::move(*why);
  const Texels& texels = std::get<Texels>(made);
  const ImageFacts& facts = texels.facts;
  Rgba rgba{static_cast<int>(facts.width), static_cast<int>(facts.height), {}};
  const std::size_t count = std::size_t{facts.width} * facts.height;
  const auto width = static_cast<std::size_t>(facts.bits) / 8;
  const auto channels = static_cast<std::size_t>(facts.channels);
  const bool has_colour = channels > 2, has_alpha = channels % 2 == 0;
  rgba.values.resize(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::byte* texel = texels.bytes.data() + i * channels * width;
    for (std::size_t c = 0; c < 3; ++c)
      rgba.values[4 * i + c] = eight_bits(texel + (has_colour ? c * width : 0), facts.bits);
    rgba.values[4 * i + 3] =
        has_alpha ? eight_bits_of_alpha(texel + (channels - 1) * width, facts.bits) : std::uint8_t{255};
  }
  return rgba;
}

std::variant<Image, std::string> png_or_jpeg(const Image& image) {
  if (!image.uri.empty()) return "is in a separate file, '" + image.uri + "'";
  Image result = image;
  result.media_type = "image/png";
  result.is_texels = false;
  if (!image.is_texels) {
    const auto header = header_of(image.bytes.view());
    if (!header) return "is of an unknown kind";
    if (header->kind == Kind::jpeg) result.media_type = "image/jpeg";
    if (header->kind == Kind::png || header->kind == Kind::jpeg) return result;
  }
  auto made = texels_of(image);
  if (std::string* why = std::get_if<std::string>(&made)) return std::move(*why);
  const Texels& texels = std::get<Texels>(made);
  const int width = static_cast<int>(texels.facts.width), height = static_cast<int>(texels.facts.height);
  if (texels.facts.bits == 8) {
    result.bytes = Shared<std::byte>(
        png_of(width, height, texels.facts.channels, reinterpret_cast<const std::uint8_t*>(texels.bytes.data())));
  } else {
    auto rgba = rgba_of(image);
    if (std::string* why = std::get_if<std::string>(&rgba)) return std::move(*why);
    result.bytes = Shared<std::byte>(png_of(width, height, 4, std::get<Rgba>(rgba).values.data()));
  }
  result.facts = image_facts(result.bytes.view());
  return result;
}

std::string data_uri(const Image& image) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:" + image.media_type + ";base64,";
  const auto bytes = image.bytes.view();
  text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace foredraw::images
