#pragma once
// The smallest rectangle and the smallest parallelogram round a hull, as CGAL finds them.

#include <plugins/processors/particle_trim/convex_hull.h>

#include <optional>
#include <span>

namespace foredraw::bench {

struct EnclosingQuadrilaterals {
  double rectangle = 0;      ///< area, however it is turned
  double parallelogram = 0;  ///< area
};

/// Round a hull of three corners or more, in the square of its unit. None where this was built without CGAL.
std::optional<EnclosingQuadrilaterals> enclosing_quadrilaterals(std::span<const processors::particle_trim::Point> hull);

}  // namespace foredraw::bench
