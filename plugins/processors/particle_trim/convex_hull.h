#pragma once
// Convex hulls of points on a grid, exactly.

#include "texel_grid.h"

#include <vector>

namespace foredraw::processors::particle_trim {

/// Which the build made out: a monotone chain in 64-bit integers, or CGAL.
std::vector<Point> convex_hull(std::vector<Point> points);

/// The corners of the hull, the least (by x, then y) first, clockwise on a screen (cross() of following edges is above
/// 0); none lies on the line between its neighbours. Fewer than three where the points have no area. Coordinates have
/// to be below 2^30. O(n log n). Source: Andrew 1979, monotone chain.
std::vector<Point> monotone_chain(std::vector<Point> points);

}  // namespace foredraw::processors::particle_trim
