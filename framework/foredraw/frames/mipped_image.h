#pragma once
// An image as a sampler reads it: 8 bits a channel, with its mip levels.

#include <foredraw/analysis/analyses.h>
#include <foredraw/image/alpha_image.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace foredraw {

struct MippedImage {
  static constexpr std::string_view name = "mipped-image";

  struct MipLevel {
    std::int32_t width = 1, height = 1;
    std::vector<std::array<std::uint8_t, 4>> texels;  ///< rows from the top
  };
  std::vector<MipLevel> levels;  ///< each half as wide and high as the one before, down to one texel; never empty

  std::size_t bytes() const;
};

/// Grey becomes red, green and blue alike; what has no alpha is opaque.
MippedImage mipped_image(const Texels& texels);

/// Decoded once and kept. Null where the image can not be decoded.
std::shared_ptr<const MippedImage> mipped_image_of(Analyses& analyses, const Image& image);

/// Four texels blended, or the nearest one, of that mip level or the last. 0 to 1. (0, 0) is the upper left corner.
glm::vec4 sampled(const MippedImage& image, const Sampling& sampling, std::size_t level, const glm::vec2& uv);

}  // namespace foredraw
