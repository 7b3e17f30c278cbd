#pragma once
// Heights without a map: one for each vertex that a tessellator makes of a draw. The product of a stage that bakes a
// surface of many triangles into few and their heights.

#include <foredraw/scene/scene.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

struct DrawHeights {
  DrawId draw = 0;
  Shared<std::uint8_t> levels;    ///< [triangle] log2 of its level, 0 to 6: baked_levels() has those of edges
  Shared<std::uint16_t> heights;  ///< [vertex of tessellated_mesh() by these levels, equal spacing] below 2^bits
  std::uint32_t bits = 16;        ///< 1 to 16
  float factor = 1;               ///< units for the largest height
  float offset = 0;               ///< units that every height is moved besides
  friend bool operator==(const DrawHeights&, const DrawHeights&) = default;
};

struct BakedHeights {
  static constexpr std::string_view product = "baked-heights";
  std::vector<DrawHeights> draws;  ///< rising; of their full detail
  friend bool operator==(const BakedHeights&, const BakedHeights&) = default;
};

/// Those of a draw; null where it has none.
const DrawHeights* heights_of(const Scene& scene, DrawId draw);

}  // namespace foredraw
