#pragma once
// Quads of draws, and the polygons that take their place.

#include "particle_trim.h"

#include <foredraw/scene/draw.h>

#include <string>
#include <variant>

namespace foredraw::processors::particle_trim {

/// A flat quad that shows an upright rectangle of an image.
struct SpriteQuad {
  std::array<std::uint32_t, 4> outline{};  ///< its vertices, as its triangles wind
  std::array<std::uint32_t, 3> axes{};     ///< those at the least u and v, at the greatest u, and at the greatest v
  TrimFrame frame;                         ///< what it shows of the image, rounded outwards
  bool is_clockwise = false;               ///< as its triangles lie in the image
};

/// The quads of a draw; or why they can not be trimmed. `image` is the one that the texture shows.
std::variant<std::vector<SpriteQuad>, std::string> sprite_quads(const Draw& draw, const Texture& texture,
                                                                const AlphaImage& image);

/// The draw with polygons in place of quads: of each the vertices, first the one with the least u (of those the least
/// v), then round it, and triangles whose inner edges are short in all, so that few pixels are shaded twice along them.
/// Every attribute goes on over the polygon as it runs over the quad. [i] is what quad i became; without corners it
/// stays.
Draw with_polygons(const Draw& draw, const std::vector<SpriteQuad>& quads, const std::vector<TrimmedSprite>& sprites,
                   const Texture& texture, const AlphaImage& image, const ParticleTrimOptions& options);

}  // namespace foredraw::processors::particle_trim
