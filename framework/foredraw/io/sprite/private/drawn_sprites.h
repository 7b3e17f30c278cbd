#pragma once
// A scene's sprites as they are drawn now, in texels. Private to io.

#include <foredraw/io/sprite/private/source.h>

#include <foredraw/base/diagnostics.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw::sprites {

struct DrawnSprite {
  FrameEntry frame;
  std::optional<std::size_t> entry;  ///< its number in the source; none: no list that was read has it
  ImageId image = 0;
  // Corners: those of each piece's outline as the triangles wind, then what lies within.
  std::vector<glm::dvec2> texcoords;     ///< (0, 0) is the image's upper left corner, (1, 1) the lower right one
  std::vector<glm::dvec2> texels;        ///< the same, in texels of the image
  std::vector<glm::dvec2> points;        ///< in texels of the whole sprite, upright, from its upper left corner
  std::vector<std::uint32_t> triangles;  ///< three corners each
  std::vector<std::vector<std::uint32_t>> outlines;  ///< of each piece that has one

  double area_part() const;  ///< of all triangles, in frames: 1 for the quad
};

/// Where a place in texels of the image lies in the whole sprite.
glm::dvec2 to_sprite(const FrameEntry& frame, const glm::dvec2& texel);

/// In the sequence of the draws. nullopt, with an error that names the target, where a draw has no frame or no image of
/// a size that is known, or there is none.
std::optional<std::vector<DrawnSprite>> drawn_sprites(const Scene& scene, const std::filesystem::path& target,
                                                      Diagnostics& diagnostics);

/// The shortest text that reads back as the same float.
std::string shortest(double value);

}  // namespace foredraw::sprites
