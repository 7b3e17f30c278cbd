// Our convex hulls against CGAL's, which has exact predicates. Where CGAL is not found this is not built.

#include <plugins/processors/particle_trim/convex_hull.h>

#include <foredraw/base/random.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>

namespace foredraw::processors::particle_trim {

// What GoogleTest shows of a point where two differ.
void PrintTo(const Point& point, std::ostream* out) { *out << '(' << point.x << ", " << point.y << ')'; }

namespace convex_hull_cgal_test {
namespace {

/// Counter-clockwise with y up, which is clockwise on a screen; from the same corner on as ours.
std::vector<Point> reference(const std::vector<Point>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> from, hull;
  for (const Point& point : points) from.emplace_back(static_cast<double>(point.x), static_cast<double>(point.y));
  CGAL::convex_hull_2(from.begin(), from.end(), std::back_inserter(hull));
  std::vector<Point> made;
  for (const Kernel::Point_2& corner : hull) {
    made.push_back({static_cast<std::int64_t>(corner.x()), static_cast<std::int64_t>(corner.y())});
  }
  if (!made.empty()) std::ranges::rotate(made, std::ranges::min_element(made));
  return made;
}

void expect_equal_hulls(const std::vector<Point>& points) {
  const std::vector<Point> expected = reference(points);
  EXPECT_EQ(monotone_chain(points), expected);
  EXPECT_EQ(convex_hull(points), expected);  // whichever the build made out
}

Point random_point(Random& random, std::int64_t size) {
  const auto bound = static_cast<std::uint64_t>(2 * size + 1);
  const std::int64_t x = static_cast<std::int64_t>(random.below(bound)) - size;
  return {x, static_cast<std::int64_t>(random.below(bound)) - size};
}

constexpr std::int64_t largest = std::int64_t{1} << 22;

TEST(ConvexHull, of_random_points_is_what_CGAL_finds) {
  Random random(21);
  for (const std::int64_t size :
       {std::int64_t{1}, std::int64_t{2}, std::int64_t{5}, std::int64_t{30}, std::int64_t{1000}, largest}) {
    for (int round = 0; round < 300; ++round) {
      std::vector<Point> points(1 + random.below(round % 10 == 0 ? 2000 : 20));
      std::ranges::generate(points, [&] { return random_point(random, size); });
      expect_equal_hulls(points);
    }
  }
}

TEST(ConvexHull, of_collinear_and_repeated_points_is_what_CGAL_finds) {
  Random random(22);
  for (int round = 0; round < 500; ++round) {
    std::vector<Point> points;
    for (std::uint64_t line = random.below(4) + 1; line-- > 0;) {
      const Point from = random_point(random, largest / 2), step = random_point(random, largest / 128);
      for (std::uint64_t i = random.below(60) + 1; i-- > 0;) {
        const auto at = static_cast<std::int64_t>(random.below(64));
        points.push_back(from + Point{step.x * at, step.y * at});
      }
    }
    const std::size_t once = points.size();
    for (std::uint64_t i = random.below(40); i-- > 0;) points.push_back(points[random.below(once)]);
    expect_equal_hulls(points);
  }
}

TEST(ConvexHull, of_points_nearly_on_a_line_is_what_CGAL_finds) {
  Random random(23);
  for (int round = 0; round < 500; ++round) {
    std::vector<Point> points;
    const Point end = random_point(random, largest);
    for (int i = 0; i < 100; ++i) {
      const double at = random.unit();
      points.push_back({std::llround(at * static_cast<double>(end.x)), std::llround(at * static_cast<double>(end.y))});
    }
    expect_equal_hulls(points);
  }
}

TEST(ConvexHull, of_a_disc_of_texels_is_what_CGAL_finds) {
  for (const std::int64_t radius : {1, 2, 7, 100, 511}) {
    std::vector<Point> points;
    for (std::int64_t y = -radius; y <= radius; ++y) {
      for (std::int64_t x = -radius; x <= radius; ++x) {
        if (x * x + y * y > radius * radius) continue;
        for (const Point& corner : {Point{0, 0}, Point{256, 0}, Point{0, 256}, Point{256, 256}})
          points.push_back(Point{x * 256, y * 256} + corner);
      }
    }
    expect_equal_hulls(points);
  }
}

TEST(ConvexHull, of_nothing_and_of_one_point_is_the_same) {
  expect_equal_hulls({});
  expect_equal_hulls({{3, 4}});
  expect_equal_hulls({{3, 4}, {3, 4}});
  expect_equal_hulls({{3, 4}, {3, -4}, {3, 0}});
}

}  // namespace
}  // namespace convex_hull_cgal_test
}  // namespace foredraw::processors::particle_trim
