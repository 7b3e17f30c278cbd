#include "enclosing_quadrilaterals.h"

#ifdef FOREDRAW_BENCH_HAS_CGAL

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/min_quadrilateral_2.h>

#include <array>

namespace foredraw::bench {

namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

double area(const std::array<Kernel::Point_2, 4>& corners) {
  return std::abs(CGAL::to_double(CGAL::Polygon_2<Kernel>(corners.begin(), corners.end()).area()));
}

}  // namespace

std::optional<EnclosingQuadrilaterals> enclosing_quadrilaterals(
    std::span<const processors::particle_trim::Point> hull) {
  std::vector<Kernel::Point_2> corners;
  for (const processors::particle_trim::Point& corner : hull) corners.emplace_back(corner.x, corner.y);
  std::array<Kernel::Point_2, 4> rectangle, parallelogram;
  CGAL::min_rectangle_2(corners.begin(), corners.end(), rectangle.begin());
  CGAL::min_parallelogram_2(corners.begin(), corners.end(), parallelogram.begin());
  return EnclosingQuadrilaterals{area(rectangle), area(parallelogram)};
}

}  // namespace foredraw::bench

#else

namespace foredraw::bench {

std::optional<EnclosingQuadrilaterals> enclosing_quadrilaterals(std::span<const processors::particle_trim::Point>) {
  return std::nullopt;
}

}  // namespace foredraw::bench

#endif
