// The hull by CGAL with exact predicates, where the build asks for it: FOREDRAW_CGAL_HULL. CGAL's hulls are under the
// GPL.
#ifdef FOREDRAW_CGAL_HULL

#include "convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ch_graham_andrew.h>

#include <iterator>

namespace foredraw::processors::particle_trim {

std::vector<Point> convex_hull(std::vector<Point> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> from;
  from.reserve(points.size());
  for (const Point& point : points) from.emplace_back(static_cast<double>(point.x), static_cast<double>(point.y));
  std::vector<Kernel::Point_2> hull;
  CGAL::ch_graham_andrew(from.begin(), from.end(), std::back_inserter(hull));
  points.clear();
  for (const Kernel::Point_2& point : hull) {
    points.push_back({static_cast<std::int64_t>(point.x()), static_cast<std::int64_t>(point.y())});
  }
  return points;
}

}  // namespace foredraw::processors::particle_trim

#endif
