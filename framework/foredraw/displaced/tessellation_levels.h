#pragma once
// How finely the triangles of displaced draws are to be divided: the product of a stage that looked at what they show.

#include <foredraw/scene/scene.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

/// Of a triangle, edges 0, 1 and 2 and the inside, as powers of two: 3 stands for 8 parts. Edge e goes from corner
/// (e + 1) % 3 to (e + 2) % 3, as in shaders. 0 to 6.
using LogLevels = std::array<std::uint8_t, 4>;
inline constexpr std::uint8_t most_log_level = 6;

/// What levels give. Displacements are in the draw's units, at rest.
struct TessellationScale {
  std::uint32_t triangles = 0;
  float rms = 0;  ///< of how far off the displacement is, over the draw's area; never less than that of finer levels
  float largest = 0;  ///< that was found; the same
  friend bool operator==(const TessellationScale&, const TessellationScale&) = default;
};

/// The least and the most displacement that points of some triangles have, at any level.
struct DisplacementRange {
  float least = 0, most = 0;
  friend bool operator==(const DisplacementRange&, const DisplacementRange&) = default;
};

/// Of full detail, in the order that stands alone.
struct DrawTessellation {
  DrawId draw = 0;
  Shared<LogLevels> levels;               ///< [triangle]
  std::vector<TessellationScale> scales;  ///< [s] of the levels with s taken from each, but not below 0; at least one
  Shared<std::uint32_t> range_begins;     ///< [range] its first triangle; rising from 0
  Shared<DisplacementRange> ranges;       ///< [range]
  friend bool operator==(const DrawTessellation&, const DrawTessellation&) = default;
};

struct StoredTessellations {
  static constexpr std::string_view product = "tessellation-levels";
  std::vector<DrawTessellation> draws;  ///< rising
  friend bool operator==(const StoredTessellations&, const StoredTessellations&) = default;
};

/// Null where the scene says nothing of the draw.
const DrawTessellation* tessellation_of(const Scene& scene, DrawId draw);

}  // namespace foredraw
