#pragma once
// Heights along the seams of displaced draws, apart from the map: what both sides of a seam read there. The product of
// a stage that makes maps equal on both sides.

#include <foredraw/runtime/seam_table.h>
#include <foredraw/scene/scene.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

/// Draws that lie on one map share the heights, and each has sides of its own. Of full detail, in the order that stands
/// alone.
struct DrawSeams {
  DrawId draw = 0;
  Shared<std::uint8_t> parts_log2;   ///< [edge] it has 2^n parts, n at most 6
  Shared<std::uint16_t> heights;     ///< those between the parts of the first edge, of the second, ...
  Shared<foredraw_seam_side> sides;  ///< rising by number
  friend bool operator==(const DrawSeams&, const DrawSeams&) = default;
};

struct SeamHeights {
  static constexpr std::string_view product = "seam-heights";
  std::vector<DrawSeams> draws;  ///< rising
  friend bool operator==(const SeamHeights&, const SeamHeights&) = default;
};

/// Null where the scene says nothing of the draw.
const DrawSeams* seams_of(const Scene& scene, DrawId draw);

}  // namespace foredraw
