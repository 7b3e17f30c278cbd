#pragma once
// What SVG says of a sprite, for overlays and pages. Private to io.

#include <foredraw/io/sprite/private/drawn_sprites.h>
#include <foredraw/io/sprite/private/write.h>

#include <string>
#include <vector>

namespace foredraw::sprites {

/// Text as SVG and HTML show it: whatever a file calls its things, it is no markup.
std::string escaped(const std::string& text);

/// "M0 0L1 0L1 1Z" for each outline, or for each triangle of a sprite that has not one. `points`: the sprite's, in the
/// space that is drawn in.
std::string polygon_path(const DrawnSprite& sprite, const std::vector<glm::dvec2>& points);

/// A dot at each corner, as a path whose stroke has round ends.
std::string corner_path(const std::vector<glm::dvec2>& points);

struct Box {
  glm::dvec2 least{0}, most{0};
};

/// Of the frame and what is drawn, in texels of the whole sprite.
Box bounds_of(const DrawnSprite& sprite);

/// Of many sprites: how many corners they have in all, and how much of their frames is drawn.
struct SheetTotals {
  std::size_t sprites = 0;
  std::size_t vertices = 0;
  double area = 0;    ///< texels of all polygons
  double frames = 0;  ///< texels of all frames
};
SheetTotals totals_of(std::span<const Sheet> sheets);

/// "24 sprites, 148 vertices, 61.2 % of the frames' area is drawn"
std::string totals_text(std::span<const Sheet> sheets);

/// The images that sprites of a scene show, as a browser takes them; nullopt, with an error, where one can not be
/// decoded. Those that no sprite shows are empty.
std::optional<std::vector<std::string>> data_uris(const Sheet& sheet, Diagnostics& diagnostics);

}  // namespace foredraw::sprites
