#pragma once
// Small convex polygons of few corners round a convex hull.

#include "pockets.h"

#include <limits>

namespace foredraw::processors::particle_trim {

struct Enclosing {
  std::vector<glm::dvec2> corners;  ///< round the hull in its own direction
  double area = 0;
};

/// The smallest convex polygon of at most n corners (3 or more) round the hull: the hull itself where it has no more.
/// Of the smallest ones some has all edges, or all but one, on edges of the hull, and that one touches the hull at its
/// midpoint (DePano 1987): so the best sequence of pockets is found by dynamic programming, with nothing left out.
/// Where `allowed` forbids some, the best of the others of this form; none where none is left whose area is at most
/// `most_area`. h edges: O(h^3 log n) at worst, and near h^2 for n from 5 on, as pockets that are larger than a polygon
/// that is known can not be part of the answer. Areas are right to 1e-14 of themselves.
std::optional<Enclosing> smallest_enclosing(std::span<const Point> hull, int n, const Allowed& allowed = {},
                                            double most_area = std::numeric_limits<double>::infinity());

/// As Persson's tool finds it ("Graphics Gems for Games", SIGGRAPH 2012, "Particle trimming"): the hull is reduced to
/// at most so many edges by removing again and again the one without which it grows least; of what is left the best n
/// edges are found by trying all sets. O(edges over n) after O(h^2).
std::optional<Enclosing> reduced_enclosing(std::span<const Point> hull, int n, int most_edges,
                                           const Allowed& allowed = {});

}  // namespace foredraw::processors::particle_trim
