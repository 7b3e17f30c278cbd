#include <plugins/processors/particle_trim/enclosing_polygon.h>
#include <plugins/processors/particle_trim/fewest_inner_edges.h>
#include <plugins/processors/particle_trim/particle_trim.h>
#include <plugins/processors/particle_trim/stored_polygon.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>

namespace foredraw::particle_trim_test {
namespace {

using processors::particle_trim::Allowed;
using processors::particle_trim::Enclosing;
using processors::particle_trim::Point;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Point> random_hull(Random& random, std::size_t most_edges, std::int64_t size) {
  std::vector<Point> points;
  const std::size_t count = 3 + random.below(3 * most_edges);
  for (std::size_t i = 0; i < count; ++i) {
    const auto coordinate = [&] { return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(size))); };
    points.push_back({coordinate(), coordinate()});
  }
  std::vector<Point> hull = processors::particle_trim::convex_hull(points);
  while (hull.size() > most_edges) hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(random.below(hull.size())));
  return hull.size() >= 3 ? hull : std::vector<Point>{{0, 0}, {size, 0}, {0, size}};
}

double doubled_area(const std::vector<glm::dvec2>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    area += p.x * q.y - p.y * q.x;
  }
  return area;
}

// --- An exhaustive search that shares nothing with the technique: half planes, cut one after the other.
// ----------------

struct Line {
  glm::dvec2 point, direction;
};

/// The polygon that lies on the right side of all lines; none where they leave it open or exclude a part of the hull.
std::optional<std::vector<glm::dvec2>> polygon_of(const std::vector<Line>& lines) {
  std::vector<glm::dvec2> corners;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line &a = lines[i], &b = lines[(i + 1) % lines.size()];
    const double turn = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
    if (!(turn > 1e-12)) return std::nullopt;
    const glm::dvec2 gap = b.point - a.point;
    corners.push_back(a.point + a.direction * ((gap.x * b.direction.y - gap.y * b.direction.x) / turn));
  }
  return corners;
}

Line edge_line(const std::vector<Point>& hull, std::size_t i) {
  const Point &a = hull[i % hull.size()], &b = hull[(i + 1) % hull.size()];
  const glm::dvec2 p(a.x, a.y), q(b.x, b.y);
  return {p, (q - p) / std::hypot(q.x - p.x, q.y - p.y)};
}

/// The line in that direction that touches the hull and has it on its right side.
Line touching(const std::vector<Point>& hull, double angle) {
  const glm::dvec2 direction(std::cos(angle), std::sin(angle));
  glm::dvec2 best(0);
  double least = infinity;
  for (const Point& corner : hull) {
    const glm::dvec2 p(corner.x, corner.y);
    const double height = direction.x * p.y - direction.y * p.x;
    if (height < least) {
      least = height;
      best = p;
    }
  }
  return {best, direction};
}

double angle_of(const Line& line) { return std::atan2(line.direction.y, line.direction.x); }

/// Sets of edges of the hull, all of them or all but one free one, which is turned to where the area is least.
double least_area(const std::vector<Point>& hull, std::size_t n) {
  double least = infinity;
  const auto take = [&](const std::vector<Line>& lines) {
    if (const auto polygon = polygon_of(lines)) {
      const double area = 0.5 * doubled_area(*polygon);
      if (area > 0) least = std::min(least, area);
    }
  };
  for (unsigned set = 0; set < 1u << hull.size(); ++set) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      if (set >> i & 1) lines.push_back(edge_line(hull, i));
    }
    if (lines.size() == n) take(lines);
    if (lines.size() + 1 != n) continue;
    for (std::size_t gap = 0; gap < lines.size(); ++gap) {
      const double from = angle_of(lines[gap]);
      double to = angle_of(lines[(gap + 1) % lines.size()]);
      while (to <= from) to += 2 * M_PI;
      const auto area_at = [&](double angle) {
        std::vector<Line> with = lines;
        with.insert(with.begin() + static_cast<std::ptrdiff_t>(gap) + 1, touching(hull, angle));
        const auto polygon = polygon_of(with);
        return polygon ? 0.5 * doubled_area(*polygon) : infinity;
      };
      // Where both neighbours can be met the area has one least value.
      double low = std::max(from, to - M_PI), high = std::min(to, from + M_PI);
      if (low >= high) continue;
      const double first = low, last = high;
      for (int step = 0; step < 90; ++step) {
        const double a = low + (high - low) * 0.381966, b = high - (high - low) * 0.381966;
        (area_at(a) <= area_at(b) ? high : low) = area_at(a) <= area_at(b) ? b : a;
      }
      for (const double angle : {low, high}) {
        if (angle > first + 1e-9 && angle < last - 1e-9 && area_at(angle) > 0) least = std::min(least, area_at(angle));
      }
    }
  }
  return least;
}

void expect_encloses(const Enclosing& polygon, const std::vector<Point>& hull, std::size_t n) {
  EXPECT_LE(polygon.corners.size(), std::max(n, std::size_t{3}));
  EXPECT_NEAR(0.5 * doubled_area(polygon.corners), polygon.area, 1e-9 * polygon.area);
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const glm::dvec2 p = polygon.corners[i], q = polygon.corners[(i + 1) % polygon.corners.size()];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    for (const Point& corner : hull) {
      const double height =
          ((q.x - p.x) * (static_cast<double>(corner.y) - p.y) - (q.y - p.y) * (static_cast<double>(corner.x) - p.x));
      EXPECT_GE(height, -1e-7 * (1 + length) * (1 + length));
    }
  }
}

TEST(SmallestEnclosing, is_what_an_exhaustive_search_finds) {
  Random random(11);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Point> hull = random_hull(random, round % 5 == 0 ? 14 : 9, round % 3 == 0 ? 12 : 4000);
    for (std::size_t n = 3; n <= 8 && n < hull.size(); ++n) {
      const auto polygon = processors::particle_trim::smallest_enclosing(hull, static_cast<int>(n));
      const double least = least_area(hull, n);
      ASSERT_TRUE(polygon);
      EXPECT_NEAR(polygon->area, least, 1e-7 * least) << "round " << round << ", n " << n << ", edges " << hull.size();
      expect_encloses(*polygon, hull, n);
    }
  }
}

TEST(SmallestEnclosing, is_never_larger_than_what_is_found_on_a_reduced_hull_and_falls_with_the_corners) {
  Random random(12);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Point> hull = random_hull(random, 60, 100000);
    double before = infinity;
    for (int n = 3; n <= 16; ++n) {
      const auto optimal = processors::particle_trim::smallest_enclosing(hull, n);
      ASSERT_TRUE(optimal);
      EXPECT_LE(optimal->area, before * (1 + 1e-12));
      before = optimal->area;
      if (n > 8) continue;
      const auto reduced = processors::particle_trim::reduced_enclosing(hull, n, 16);
      if (reduced) {
        EXPECT_LE(optimal->area, reduced->area * (1 + 1e-12));
        expect_encloses(*reduced, hull, static_cast<std::size_t>(n));
      }
    }
  }
}

TEST(SmallestEnclosing, of_a_square_is_known) {
  const std::vector<Point> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_NEAR(processors::particle_trim::smallest_enclosing(square, 3)->area, 200, 1e-9);
  EXPECT_EQ(processors::particle_trim::smallest_enclosing(square, 4)->area, 100);
  EXPECT_EQ(processors::particle_trim::smallest_enclosing(square, 16)->corners.size(), 4u);
}

TEST(SmallestEnclosing, keeps_to_what_is_allowed_and_takes_the_next_best) {
  Random random(13);
  int forbidden = 0;
  for (int round = 0; round < 40; ++round) {
    const std::vector<Point> hull = random_hull(random, 30, 5000);
    const double edge = 5000.0 + static_cast<double>(random.below(500));
    const Allowed allowed = [&](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
      return std::max({a.x, b.x, c.x}) <= edge;
    };
    for (int n = 3; n <= 8; ++n) {
      const auto free = processors::particle_trim::smallest_enclosing(hull, n);
      const auto kept = processors::particle_trim::smallest_enclosing(hull, n, allowed);
      if (!kept) {
        ++forbidden;
        continue;
      }
      EXPECT_GE(kept->area, free->area * (1 - 1e-12));
      if (kept->area > free->area * (1 + 1e-9)) ++forbidden;
      for (const glm::dvec2& corner : kept->corners) EXPECT_LE(corner.x, edge + 1e-6);
      const auto bounded = processors::particle_trim::smallest_enclosing(hull, n, allowed, kept->area * (1 + 1e-9));
      ASSERT_TRUE(bounded);
      EXPECT_NEAR(bounded->area, kept->area, 1e-9 * kept->area);
      EXPECT_FALSE(processors::particle_trim::smallest_enclosing(hull, n, allowed, kept->area * (1 - 1e-6)) &&
                   hull.size() > static_cast<std::size_t>(n));
    }
  }
  EXPECT_GT(forbidden, 20);
}

TEST(ConvexHull, holds_all_points_and_turns_one_way) {
  Random random(14);
  for (int round = 0; round < 200; ++round) {
    std::vector<Point> points;
    const std::int64_t size = 1 + static_cast<std::int64_t>(random.below(round % 2 == 0 ? 6 : 1 << 22));
    for (std::size_t i = 0; i < 1 + random.below(60); ++i) {
      const auto coordinate = [&] { return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(size))); };
      points.push_back({coordinate(), coordinate()});
    }
    const std::vector<Point> hull = processors::particle_trim::monotone_chain(points);
    EXPECT_EQ(hull, processors::particle_trim::convex_hull(points));
    if (hull.size() < 3) continue;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point &a = hull[i], &b = hull[(i + 1) % hull.size()], &c = hull[(i + 2) % hull.size()];
      EXPECT_GT(cross(b - a, c - b), 0);
      for (const Point& point : points) EXPECT_GE(cross(b - a, point - a), 0);
    }
  }
}

TEST(FewestInnerEdges, cut_a_polygon_into_triangles_of_its_own_direction) {
  std::vector<glm::dvec2> corners;
  for (int i = 0; i < 9; ++i) corners.emplace_back(100 * std::cos(i * 2 * M_PI / 9), 10 * std::sin(i * 2 * M_PI / 9));
  const auto triangles = processors::particle_trim::fewest_inner_edges(corners);
  ASSERT_EQ(triangles.size(), 7u);
  double area = 0, inner = 0, fan = 0;
  for (const auto& [a, b, c] : triangles) {
    const double one = doubled_area({corners[a], corners[b], corners[c]});
    EXPECT_GT(one, 0);
    area += one;
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
      if ((p + 1) % 9 != q) inner += glm::distance(corners[p], corners[q]) / 2;
    }
  }
  for (int i = 2; i < 8; ++i) fan += glm::distance(corners[0], corners[static_cast<std::size_t>(i)]);
  EXPECT_NEAR(area, doubled_area(corners), 1e-9);
  EXPECT_LT(inner, fan);
  EXPECT_TRUE(processors::particle_trim::fewest_inner_edges(std::vector<glm::dvec2>(2)).empty());
}

TEST(StoredPolygon, holds_what_was_in_it_in_every_format) {
  Random random(15);
  AlphaImage image{800, 300, {}};
  for (const processors::particle_trim::UvFormat format :
       {processors::particle_trim::UvFormat::float32, processors::particle_trim::UvFormat::float16,
        processors::particle_trim::UvFormat::unorm16}) {
    for (int round = 0; round < 300; ++round) {
      std::vector<Point> points;
      for (int i = 0; i < 40; ++i) {
        points.push_back({256 * 30 + static_cast<std::int64_t>(random.below(740 * 256)),
                          256 * 30 + static_cast<std::int64_t>(random.below(240 * 256))});
      }
      const std::vector<Point> hull = processors::particle_trim::convex_hull(points);
      std::vector<glm::dvec2> corners;
      for (const Point& point : hull) corners.emplace_back(point.x, point.y);
      const auto polygon = processors::particle_trim::StoredPolygon::round(corners, image, format);
      ASSERT_TRUE(polygon);
      for (const Point& point : points) EXPECT_TRUE(polygon->holds(point));
      EXPECT_FALSE(polygon->holds({hull[0].x - 256 * 3, hull[0].y}));
      const double exact = 0.5 * doubled_area(corners) / (256 * 256);
      EXPECT_GE(polygon->area(), exact);
      EXPECT_LT(polygon->area(), exact * (format == processors::particle_trim::UvFormat::float16 ? 1.05 : 1.001));
      for (const glm::dvec2& uv : polygon->texture_coordinates()) {
        EXPECT_EQ(static_cast<double>(static_cast<float>(uv.x)), format == processors::particle_trim::UvFormat::unorm16
                                                                     ? static_cast<double>(static_cast<float>(uv.x))
                                                                     : uv.x);
      }
    }
  }
}

}  // namespace
}  // namespace foredraw::particle_trim_test
