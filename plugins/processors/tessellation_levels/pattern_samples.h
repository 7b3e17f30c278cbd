#pragma once
// Points all over a triangle, and where they lie in what a tessellator makes of it.

#include <foredraw/displaced/tessellation_pattern.h>

#include <array>
#include <cstdint>
#include <vector>

namespace foredraw {

/// The middles of the parts^2 equal triangles that a triangle falls into, in 1/65536.
std::vector<TessellationPoint> sample_points(std::uint32_t parts);

/// A point within a triangle of a pattern.
struct LocatedSample {
  std::array<std::uint16_t, 3> corners{};  ///< points of the pattern
  std::array<float, 3> weights{};          ///< theirs; the sum is 1
};

/// [sample] of sample_points(parts): where each lies. On an edge between two triangles it belongs to the first one.
std::vector<LocatedSample> located_samples(const TessellationPattern& pattern, std::uint32_t parts);

}  // namespace foredraw
