// Where an image shows, held against samples of it.
#include <plugins/processors/particle_trim/footprint.h>
#include <plugins/processors/particle_trim/shown_cells.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <cmath>

namespace foredraw::particle_trim_footprint_test {
namespace {

using processors::particle_trim::Box;
using processors::particle_trim::Footprint;
using processors::particle_trim::FootprintOptions;
using processors::particle_trim::Point;
using processors::particle_trim::ShownImage;

/// Blots, so that outlines run at all angles; with values of all sizes.
AlphaImage random_image(Random& random, std::uint32_t most) {
  const auto side = [&] { return 1 + static_cast<std::uint32_t>(random.below(most)); };
  AlphaImage image{side(), side(), {}};
  image.alpha.assign(std::size_t{image.width} * image.height, 0);
  for (std::size_t blot = 0; blot < 1 + random.below(3); ++blot) {
    const double x = random.unit() * image.width, y = random.unit() * image.height;
    const double radius = 0.6 + random.unit() * most / 3;
    for (std::uint32_t v = 0; v < image.height; ++v) {
      for (std::uint32_t u = 0; u < image.width; ++u) {
        const double from = std::hypot(u + 0.5 - x, v + 0.5 - y) / radius;
        if (from < 1)
          image.alpha[std::size_t{v} * image.width + u] =
              static_cast<std::uint16_t>(65535 * (1 - from) * random.unit());
      }
    }
  }
  return image;
}

Sampling random_sampling(Random& random, bool is_nearest) {
  const auto wrap = [&] { return static_cast<Wrap>(random.below(3)); };
  return {{wrap(), wrap()}, is_nearest};
}

Box random_frame(Random& random, const AlphaImage& image) {
  const auto range = [&](std::uint32_t side) {
    const std::int64_t a = static_cast<std::int64_t>(random.below(side)),
                       b = a + 1 + static_cast<std::int64_t>(random.below(side - static_cast<std::uint64_t>(a)));
    return std::pair{a * 256, b * 256};
  };
  const auto [left, right] = range(image.width);
  const auto [up, down] = range(image.height);
  return {{left, up}, {right, down}};
}

/// Inside of a hull or on its edges.
bool holds(const std::vector<Point>& hull, const Point& point) {
  if (hull.size() < 3) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (cross(hull[(i + 1) % hull.size()] - hull[i], point - hull[i]) < 0) return false;
  }
  return true;
}

double area_of(const std::vector<Point>& hull) {
  std::int64_t doubled = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) doubled += cross(hull[i], hull[(i + 1) % hull.size()]);
  return 0.5 * static_cast<double>(doubled);
}

double sample(const AlphaImage& image, const Sampling& sampling, const Point& at) {
  return alpha_at(image, sampling, glm::dvec2(at.x, at.y) / 256.0 / glm::dvec2(image.width, image.height));
}

TEST(Footprint, holds_every_place_that_shows) {
  Random random(21);
  int shown = 0;
  for (int round = 0; round < 3000; ++round) {
    const AlphaImage image = random_image(random, 24);
    const bool is_nearest = round % 4 == 0;
    const Sampling sampling = random_sampling(random, is_nearest);
    const double threshold = round % 2 == 0 ? 0 : random.unit() * 0.6;
    const Footprint footprint = is_nearest       ? Footprint::texels
                                : round % 3 == 0 ? Footprint::bilinear_loose
                                                 : Footprint::bilinear;
    const ShownImage parts(image, sampling, {threshold, footprint});
    const Box frame = random_frame(random, image);
    const std::vector<Point> points = parts.shown_points(frame);
    const std::vector<Point> hull = processors::particle_trim::convex_hull(points);
    const std::vector<Point> padded = processors::particle_trim::padded_hull(points, frame, parts.options());
    for (const Point& corner : hull) EXPECT_TRUE(holds(padded, corner));
    for (int i = 0; i < 3000; ++i) {
      const auto between = [&](std::int64_t least, std::int64_t most) {
        return least + static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(most - least + 1)));
      };
      const Point at{between(frame.least.x, frame.most.x), between(frame.least.y, frame.most.y)};
      if (!(sample(image, sampling, at) > threshold)) continue;
      ++shown;
      if (is_nearest && (at.x == frame.most.x || at.y == frame.most.y)) continue;  // of the texel beyond the frame
      ASSERT_TRUE(holds(hull, at)) << "round " << round << " at " << at.x << ", " << at.y;
    }
  }
  EXPECT_GT(shown, 10000);
}

TEST(Footprint, follows_the_blend_closely) {
  Random random(22);
  double loose_area = 0, tight_area = 0, least_area = 0;
  for (int round = 0; round < 60; ++round) {
    const AlphaImage image = random_image(random, 20);
    const Sampling sampling{{Wrap::clamped, Wrap::clamped}, false};
    const double threshold = 0.1 + random.unit() * 0.3;
    const Box frame{{0, 0}, {image.width * 256, image.height * 256}};
    std::vector<Point> showing;
    for (std::int64_t y = frame.least.y; y <= frame.most.y; y += 16) {
      for (std::int64_t x = frame.least.x; x <= frame.most.x; x += 16) {
        if (sample(image, sampling, {x, y}) > threshold) showing.push_back({x, y});
      }
    }
    if (showing.size() < 500) continue;
    const auto hull_area = [&](Footprint footprint) {
      return area_of(processors::particle_trim::convex_hull(
          ShownImage(image, sampling, {threshold, footprint}).shown_points(frame)));
    };
    least_area += area_of(processors::particle_trim::convex_hull(showing));
    tight_area += hull_area(Footprint::bilinear);
    loose_area += hull_area(Footprint::bilinear_loose);
  }
  EXPECT_GE(tight_area, least_area);
  EXPECT_LT(tight_area - least_area, 0.15 * (loose_area - least_area));
}

TEST(Footprint, of_one_texel_is_known) {
  AlphaImage image{5, 5, std::vector<std::uint16_t>(25, 0)};
  image.alpha[12] = 65535;
  const Box frame{{0, 0}, {5 * 256, 5 * 256}};
  const Sampling sampling{{Wrap::clamped, Wrap::clamped}, false};
  const auto hull = [&](FootprintOptions options) {
    return processors::particle_trim::convex_hull(ShownImage(image, sampling, options).shown_points(frame));
  };
  EXPECT_EQ(hull({0, Footprint::texels}), (std::vector<Point>{{512, 512}, {768, 512}, {768, 768}, {512, 768}}));
  EXPECT_EQ(hull({0, Footprint::bilinear}), (std::vector<Point>{{384, 384}, {896, 384}, {896, 896}, {384, 896}}));
  EXPECT_EQ(hull({0.5, Footprint::bilinear_loose}), hull({0, Footprint::bilinear}));
  // Above a half the blend is a small curved diamond of half a texel to each side.
  const std::vector<Point> tight = hull({0.5, Footprint::bilinear});
  EXPECT_TRUE(holds(tight, {640, 512}));
  EXPECT_TRUE(holds(tight, {767, 640}));
  EXPECT_FALSE(holds(tight, {640, 509}));
  EXPECT_FALSE(holds(tight, {528, 528}));
  EXPECT_TRUE(hull({1, Footprint::bilinear}).empty());
}

TEST(Footprint, reaches_further_with_each_mip_level) {
  AlphaImage image{32, 32, std::vector<std::uint16_t>(32 * 32, 0)};
  image.alpha[32 * 13 + 17] = 65535;
  const Box frame{{0, 0}, {32 * 256, 32 * 256}};
  const Sampling sampling{{Wrap::clamped, Wrap::clamped}, false};
  for (const double threshold : {0.0, 0.01, 0.3}) {
    double before = 0;
    for (int levels = 0; levels <= 3; ++levels) {
      const ShownImage parts(image, sampling, {threshold, Footprint::bilinear, levels});
      const std::vector<Point> hull = processors::particle_trim::convex_hull(parts.shown_points(frame));
      EXPECT_GE(area_of(hull), before);
      before = area_of(hull);
      for (std::size_t i = 0; i < parts.levels(); ++i) {
        for (std::int64_t y = 0; y <= frame.most.y; y += 32) {
          for (std::int64_t x = 0; x <= frame.most.x; x += 32) {
            const AlphaImage& level = parts.level(i);
            const double alpha = alpha_at(level, sampling, glm::dvec2(x, y) / 256.0 / 32.0);
            ASSERT_TRUE(!(alpha > threshold) || holds(hull, {x, y}));
          }
        }
      }
    }
  }
}

TEST(ShownCells, find_whatever_shows_in_a_triangle_outside_of_the_frame) {
  Random random(23);
  int clear = 0, covered = 0;
  for (int round = 0; round < 1500; ++round) {
    const AlphaImage image = random_image(random, 16);
    const bool is_nearest = round % 4 == 0;
    const Sampling sampling = random_sampling(random, is_nearest);
    const double threshold = round % 2 == 0 ? 0 : random.unit() * 0.3;
    const ShownImage parts(image, sampling, {threshold, is_nearest ? Footprint::texels : Footprint::bilinear});
    const Box frame = random_frame(random, image);
    const auto place = [&] {
      const double x = (random.unit() * 3 - 1) * image.width, y = (random.unit() * 3 - 1) * image.height;
      return glm::dvec2(x, y) * 256.0;
    };
    const glm::dvec2 a = place(), b = place(), c = place();
    const bool shows = parts.cells().shows_outside(frame, a, b, c);
    bool found = false;
    for (int i = 0; i < 400; ++i) {
      double s = random.unit(), t = random.unit();
      if (s + t > 1) s = 1 - s, t = 1 - t;
      const glm::dvec2 at = glm::floor(a + s * (b - a) + t * (c - a));
      const Point point{static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y)};
      const bool is_outside = point.x < frame.least.x - 2 || point.x > frame.most.x + 2 ||
                              point.y < frame.least.y - 2 || point.y > frame.most.y + 2;
      if (!is_outside || !(sample(image, sampling, point) > threshold)) continue;
      // A step within the triangle.
      const auto side = [](const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
        return ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / std::hypot(q.x - p.x, q.y - p.y);
      };
      const double ab = side(a, b, at), bc = side(b, c, at), ca = side(c, a, at);
      if (std::min({ab, bc, ca}) > 4 || std::max({ab, bc, ca}) < -4) found = true;
    }
    EXPECT_TRUE(shows || !found) << "round " << round;
    (shows ? covered : clear) += 1;
  }
  EXPECT_GT(clear, 100);
  EXPECT_GT(covered, 100);
}

}  // namespace
}  // namespace foredraw::particle_trim_footprint_test
