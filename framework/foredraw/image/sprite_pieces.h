#pragma once
// Flat pieces of meshes that show parts of an image: quads, and the polygons that stand in their place.

#include <foredraw/scene/draw.h>

#include <cstdint>
#include <vector>

namespace foredraw {

/// Triangles that hang together by corners of equal position and texture coordinates.
struct SpritePiece {
  std::vector<std::uint32_t> triangles;  ///< their numbers, rising
  std::vector<std::uint32_t> outline;    ///< vertices round it as the triangles wind; empty: it has not one outline
};

/// In the sequence of each one's first triangle. Only of draws of triangles whose vertices have positions and these
/// texture coordinates; of others there are none.
std::vector<SpritePiece> sprite_pieces(const Draw& draw, std::uint32_t texcoord = 0);

/// Whether every piece is a parallelogram that shows an upright rectangle of the image, which may be turned by quarters
/// or mirrored: what is drawn where a sprite is not trimmed.
bool is_made_of_quads(const Draw& draw, std::uint32_t texcoord = 0);

/// Whether every piece has one outline, of at most 16 vertices, and shows the image evenly: as quads do, and the
/// polygons that take their place.
bool is_made_of_sprites(const Draw& draw, std::uint32_t texcoord = 0);

}  // namespace foredraw
