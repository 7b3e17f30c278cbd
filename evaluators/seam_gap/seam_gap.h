#pragma once
// How far heights differ between the sides of a seam.

#include <foredraw/analysis/seam_points.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foredraw {

struct SeamGapOptions {
  int samples = 201;  ///< points an edge, both ends included
  int bits = 14;      ///< that heights have to agree in
};

struct SeamGap {
  std::size_t edges = 0;                     ///< seams
  std::size_t samples = 0;                   ///< points on them at which the gap was taken
  double largest = 0;                        ///< gap, as part of the map's range
  double squares = 0;                        ///< of the gaps, together
  std::size_t points = 0;                    ///< at the factors of the rule: corners, and inside of edges
  std::size_t unequal = 0;                   ///< of them
  std::size_t below = 0;                     ///< edges that are not exact at the factor of the rule
  std::size_t torn = 0;                      ///< of these, with an end that is unequal: they gape at every factor
  std::vector<double> largest_of;            ///< [edge] 0 of borders
  std::vector<std::uint32_t> rule, factors;  ///< [edge] seam_factors(), and up to which it is exact
};

/// The gap at a point of an edge is the largest less the smallest height of its sides. Along edges it is taken in
/// doubles, from the exact uvs and four texels (one, where the map is sampled so), at equidistant points. At the
/// factors of seam_factors(), heights are whole numbers, as displaced_height.h has them. O(edges * samples).
SeamGap seam_gap(const SeamEdges& seams, const foredraw_height_map& map, const SeamGapOptions& options = {});

struct Plugin;
Plugin seam_gap_plugin();

}  // namespace foredraw
