#pragma once
// What of an image shows: a number for each texel, and what a sampler makes of them.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/texture.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace foredraw {

/// Samplers place a point between texels in so many steps.
inline constexpr std::int64_t steps_per_texel = 256;

/// What makes a texel show.
enum class AlphaChannel : std::uint8_t {
  alpha,      ///< its alpha; 1 where the image has none
  luminance,  ///< of its colour, as stored (Rec. 709 weights): for sprites that are added to what is there
  any,        ///< the greatest of its channels
};

/// The alpha of an image's texels, row after row from the top.
struct AlphaImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint16_t> alpha;  ///< 0 to 65535; what is not 0 in the image is not 0 here
  bool is_made_up = false;           ///< alpha was asked for, and the image has no such channel

  std::uint16_t at(std::uint32_t x, std::uint32_t y) const { return alpha[std::size_t{y} * width + x]; }
};

AlphaImage alpha_image(const Texels& texels, AlphaChannel channel = AlphaChannel::alpha);

/// Decoded once and kept, by its bytes or by where they lie; or why it can not be decoded.
std::variant<std::shared_ptr<const AlphaImage>, std::string> alpha_image_of(Analyses& analyses, const Image& image,
                                                                            AlphaChannel channel = AlphaChannel::alpha);

/// The next mip level: of half the size, rounded down but not to 0, each texel the mean of those that it covers, in
/// part where the size is odd; rounded up.
AlphaImage next_level(const AlphaImage& image);

/// The texel that stands at a place inside the image or beyond its edges.
std::uint32_t wrapped(std::int64_t texel, std::uint32_t count, Wrap wrap);

/// How a texture is sampled.
struct Sampling {
  std::array<Wrap, 2> wrap{};  ///< along u and v
  bool is_nearest = false;
};

/// The alpha at a place, 0 to 1; (0, 0) is the image's upper left corner, (1, 1) the lower right one. Of the nearest
/// texel, or of four blended by the place between their centres, which is rounded to 1/256 texel.
double alpha_at(const AlphaImage& image, const Sampling& sampling, const glm::dvec2& uv);

}  // namespace foredraw
