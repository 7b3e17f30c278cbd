#pragma once
// What a tessellator makes of a triangle.

#include <foredraw/displaced/edge_division.h>

#include <array>
#include <cstdint>
#include <vector>

namespace foredraw {

/// Into how many parts the edges of a triangle are divided. Edge e lies across from corner e, so it goes from corner
/// (e + 1) % 3 to (e + 2) % 3.
struct TessellationLevels {
  std::array<float, 3> outer = {1, 1, 1};  ///< [edge] gl_TessLevelOuter
  float inner = 1;                         ///< gl_TessLevelInner[0]
  friend bool operator==(const TessellationLevels&, const TessellationLevels&) = default;
};

/// The levels that the tessellator works with: each one's effective_level(), with these exceptions. If an outer level
/// is 0 then, all are: the patch is not drawn. An inner level that is 0, negative or NaN is the least one instead. If
/// it is 1 and an outer one is not, it is the next higher one, so that there is a point inside: 2 with equal spacing,
/// and 1 + 1 / 65536 with fractional odd spacing. Effective levels of effective levels are themselves.
TessellationLevels effective_levels(const TessellationLevels& levels, TessellationSpacing spacing);

/// A point of a triangle by the weights of its corners, which sum up to 65536. That many are 1, exactly in float too.
struct TessellationPoint {
  std::uint32_t u = 0, v = 0;

  std::uint32_t w() const { return weight_one - u - v; }
  std::array<std::uint32_t, 3> weights() const { return {u, v, w()}; }
  /// gl_TessCoord.
  std::array<float, 3> coordinates() const {
    constexpr float one = weight_one;
    return {static_cast<float>(u) / one, static_cast<float>(v) / one, static_cast<float>(w()) / one};
  }
  friend bool operator==(const TessellationPoint&, const TessellationPoint&) = default;
};

struct TessellationPattern {
  /// Corners 0, 1 and 2; those within edge 0 from corner 1 to 2, within edge 1 from 2 to 0, within edge 2 from 0 to 1;
  /// then those inside, ring by ring. Several may lie in one place where the level is just above a whole one.
  std::vector<TessellationPoint> points;
  /// They turn as the corners 0, 1, 2 do, which is `cw` in shaders.
  std::vector<std::array<std::uint16_t, 3>> triangles;
};

/// Points and triangles as Vulkan's tessellator makes them of a patch in the triangle domain; none, if the patch is not
/// drawn. Vulkan leaves some freedom: where points lie inside, and how they make triangles. Here they are as Direct3D
/// 11 has them, in its fixed point, which is what Mesa's software driver does too. Points on an edge depend on its own
/// level and the spacing alone, and lie in the same places from both ends.
TessellationPattern tessellation_pattern(const TessellationLevels& levels, TessellationSpacing spacing);

/// How much of it there is.
struct TessellationCounts {
  std::uint32_t points = 0, triangles = 0;
  friend bool operator==(const TessellationCounts&, const TessellationCounts&) = default;
};

/// Let an edge have n[e] parts and the inner level stand for m of them. Then there are n[0] + n[1] + n[2] + 3(m - 2) +
/// floor(1.5 (m - 2)^2) triangles, or 1 if all four are 1. With n[e] = m that is floor(1.5 m^2).
TessellationCounts tessellation_counts(const TessellationLevels& levels, TessellationSpacing spacing);

}  // namespace foredraw
