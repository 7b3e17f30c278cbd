#pragma once
// How many pixels sprites fill, and how many of these show.

#include <foredraw/image/alpha_image.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

struct SpriteFillOptions {
  std::string scales = "1 0.5 0.25";  ///< pixels a texel, spaces between; each above 0, at most 16
  int turns = 3;                      ///< at each scale, 1 to 64
  double threshold = 0;               ///< what shows has more alpha than this, 0 to 1
  AlphaChannel channel = AlphaChannel::alpha;
  bool mipmaps = true;    ///< else the image is sampled as it is at every scale
  std::int64_t seed = 1;  ///< of the offsets
};

/// How a sprite is laid onto the pixels: its image scaled and turned about the image's upper left corner, which then is
/// moved to the offset.
struct SpriteLook {
  double scale = 1;      ///< pixels a texel
  double angle = 0;      ///< radians
  glm::dvec2 offset{0};  ///< pixels, each below 1
};

/// Every scale in as many turns as the options say: the first of a scale is upright, each further one a golden angle
/// (137.5 degrees) on, and each is moved by a part of a pixel. They depend on the options alone, so all draws get the
/// same looks, before a stage and after it. Throws std::invalid_argument where `scales` is no list of scales.
std::vector<SpriteLook> sprite_looks(const SpriteFillOptions& options);

/// A triangle in the image, (0, 0) upper left, (1, 1) lower right, and how often it is drawn.
struct PlacedTriangle {
  std::array<glm::dvec2, 3> corners;
  std::uint64_t times = 1;
};

/// Three indices a triangle into `places`. Equal triangles are held once; what has a corner that is not finite is not
/// drawn, and left out.
std::vector<PlacedTriangle> placed_triangles(std::span<const glm::dvec2> places,
                                             std::span<const std::uint32_t> indices);

/// An image and its mip levels down to one texel.
using AlphaLevels = std::vector<std::shared_ptr<const AlphaImage>>;
AlphaLevels alpha_levels(std::shared_ptr<const AlphaImage> image);

struct SpriteFill {
  std::uint64_t filled = 0;  ///< pixels whose centre a triangle covers, once for each such triangle
  std::uint64_t needed = 0;  ///< those of them that show
};

/// Draws the triangles in one look. Corners are rounded to 1/256 pixel, and which centres lie inside is exact (a centre
/// on an edge belongs to the triangle below it or to the right of it). A centre is sampled where it lies in the image,
/// so what it shows does not depend on the triangle that covers it: trilinear, the level being the one whose texels are
/// as large as pixels, in steps of 1/256; nearest texels where the sampling says so, of the same levels.
///
/// O(pixels). Throws std::runtime_error where the triangles cover more than 2^30 pixels, or reach further from the
/// image's corner than 2^20 pixels or sides of the image.
SpriteFill sprite_fill(std::span<const PlacedTriangle> triangles, const AlphaLevels& levels, const Sampling& sampling,
                       const SpriteLook& look, const SpriteFillOptions& options = {});

struct Plugin;
Plugin sprite_fill_plugin();

}  // namespace foredraw
