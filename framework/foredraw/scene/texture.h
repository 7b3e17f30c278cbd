#pragma once
#include <foredraw/scene/image.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace foredraw {

/// What lies beyond the image's edges.
enum class Wrap : std::uint8_t { repeat, mirrored, clamped };

/// Which texels of an image lie where on a surface.
struct Texture {
  std::optional<ImageId> image;  ///< none: of a kind that an extension alone knows
  std::uint32_t texcoord = 0;    ///< the stream TEXCOORD_n; (0, 0) is the upper left corner of the image
  std::array<Wrap, 2> wrap{};    ///< along u and v
  bool is_nearest = false;       ///< a texel has hard edges, and is not blended into its neighbours
  // KHR_texture_transform: coordinates are scaled, turned counter-clockwise as they lie in the image, and moved.
  glm::dvec2 scale{1};
  double rotation = 0;  ///< radians
  glm::dvec2 offset{0};

  friend bool operator==(const Texture&, const Texture&) = default;
};

/// What other coordinates of a set are of those that vertices hold: offset + scale * these.
struct ScaledTexcoords {
  std::uint32_t set = 0;  ///< the stream TEXCOORD_n
  glm::dvec2 offset{0};
  glm::dvec2 scale{1};
  friend bool operator==(const ScaledTexcoords&, const ScaledTexcoords&) = default;
};

/// Rows from the top, channels interleaved, no padding. 8 or 16 bits unsigned a channel in the machine's byte order, as
/// stored (fewer than 8 and palettes become 8); 32-bit float where the image holds floats, of 16 bits too.
struct Texels {
  ImageFacts facts;  ///< of these texels: `bits` is 8, 16 or 32
  std::vector<std::byte> bytes;
};

}  // namespace foredraw
