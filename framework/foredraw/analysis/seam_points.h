#pragma once
// Points along seams at which a displacement map has to say the same on all sides, and what it says.

#include <foredraw/analysis/seam_edges.h>
#include <foredraw/runtime/displaced_height.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// One point of the surface, and where its sides lie in the map.
struct SeamPoint {
  static constexpr std::uint32_t no_edge = ~std::uint32_t{0};
  std::uint32_t edge = no_edge;  ///< among the seam edges' edges; none: a corner, in their sequence
  std::uint32_t step = 0;        ///< at step/factor of the edge
  std::uint32_t first_place = 0;
  std::uint32_t place_count = 0;
};

struct SeamPoints {
  std::vector<std::uint32_t> factors;  ///< [edge], as they were given
  std::vector<SeamPoint> points;       ///< corners, then those inside of edges, by edge and step
  std::vector<glm::ivec2> places;      ///< in 1/256 texel, as displaced_height.h has them

  std::span<const glm::ivec2> places_of(const SeamPoint& point) const {
    return std::span(places).subspan(point.first_place, point.place_count);
  }
};

/// [edge] The tessellation factor up to which a seam can be exact: the largest power of two that is at most 64 and puts
/// points no closer than 1.5 texels on the shortest side, but at least 1. Of borders 0.
std::vector<std::uint32_t> seam_factors(const SeamEdges& seams, glm::uvec2 size);

/// Corners, and points inside of seams at these factors: powers of two up to 65536, one an edge; 0 and 1 have no point
/// inside. `map` says size and wrapping.
SeamPoints seam_points(const SeamEdges& seams, std::span<const std::uint32_t> factors, const foredraw_height_map& map);

/// [point] whether its heights differ in the first `bits` bits.
std::vector<bool> unequal_points(const SeamPoints& points, const foredraw_height_map& map, std::uint32_t bits);

/// [edge] The largest power of two, at most the point's factor, at all of whose steps and at both ends the heights of
/// the edge are equal; 0: none.
std::vector<std::uint32_t> exact_factors(const SeamEdges& seams, const SeamPoints& points,
                                         const std::vector<bool>& is_unequal);

}  // namespace foredraw
