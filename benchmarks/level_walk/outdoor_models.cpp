#include "outdoor_models.h"

#include "shapes.h"
#include "solid_noise.h"

#include <foredraw/base/random.h>
#include <foredraw/scene/turn.h>

#include <algorithm>
#include <cmath>

namespace foredraw::bench {

namespace {

glm::dvec3 around_y(double angle, double radius, double height) {
  const Turn turn = turn_by(angle);
  return {radius * turn.cosine, height, radius * turn.sine};
}

/// A parabola from one point to another that goes towards a third.
std::function<glm::dvec3(double)> bow(const glm::dvec3& from, const glm::dvec3& over, const glm::dvec3& to) {
  return [=](double t) { return (1 - t) * (1 - t) * from + 2 * t * (1 - t) * over + t * t * to; };
}

/// Radii and heights of a street's pieces, as parts of the height.
std::vector<glm::dvec2> outline(std::uint64_t kind) {
  switch (kind) {
    case 0:  // bollard
      return {{0, 0}, {.16, 0}, {.17, .06}, {.12, .1}, {.11, .7}, {.14, .74}, {.14, .8}, {.1, .84}, {.12, .92}, {0, 1}};
    case 1:  // hydrant
      return {{0, 0}, {.3, 0}, {.3, .08}, {.2, .1}, {.2, .6}, {.27, .62}, {.27, .7}, {.2, .74}, {.16, .92}, {0, 1}};
    case 2:  // bin
      return {{0, 0}, {.26, 0}, {.3, .1}, {.36, .8}, {.4, .84}, {.4, .88}, {.28, .96}, {0, 1}};
    case 3:  // planter
      return {{0, 0}, {.4, 0}, {.42, .1}, {.5, .8}, {.62, .86}, {.62, 1}, {.52, 1}, {.46, .84}, {0, .8}};
    case 4:  // urn
      return {{0, 0},   {.26, 0}, {.24, .1}, {.08, .2}, {.1, .3}, {.34, .6},
              {.3, .8}, {.2, .9}, {.3, 1},   {.2, .96}, {0, .6}};
    default:  // column
      return {{0, 0}, {.2, 0}, {.2, .06}, {.13, .1}, {.12, .5}, {.11, .86}, {.18, .92}, {.2, .94}, {.2, 1}, {0, 1}};
  }
}

}  // namespace

std::vector<ModelPart> tree(double height, std::uint64_t seed) {
  Random random(seed);
  SurfaceMesh wood, leaves;
  const glm::dvec3 top{within(random, -.04, .04) * height, .62 * height, within(random, -.04, .04) * height};
  const auto trunk = bow({0, 0, 0}, {0, .3 * height, 0}, top);
  const double thick = within(random, .022, .032) * height;
  add_tube(wood, {trunk,
                  [=](double t) { return thick * (1.5 - t) * (1 + .6 * std::max(0.0, .1 - t) / .1); },
                  16,
                  40,
                  false,
                  {2, 6}});
  add_boulder(leaves,
              {top + glm::dvec3(0, .12 * height, 0), glm::dvec3(.2, .24, .2) * height, 10, .5, 4, 4, random.next()});
  constexpr int branches = 6;
  for (int i = 0; i < branches; ++i) {
    const double angle = circle * (i + random.unit()) / branches, low = within(random, .6, .95);
    const double out = within(random, .12, .15), up = within(random, .06, .2);
    const glm::dvec3 from = trunk(low), tip = from + around_y(angle, out * height, up * height);
    const auto branch = bow(from, from + around_y(angle, .1 * height, .02 * height), tip);
    add_tube(wood, {branch, [=](double t) { return thick * .5 * (1.1 - t); }, 8, 14, false, {1, 3}});
    const glm::dvec3 radii{within(random, .1, .14), within(random, .09, .13), within(random, .1, .14)};
    add_boulder(leaves, {tip, radii * height, 10, .5, 3, 4, random.next()});
  }
  return {{std::move(wood), "bark"}, {std::move(leaves), seed % 3 == 0 ? "young leaves" : "leaves"}};
}

std::vector<ModelPart> bush(double size, std::uint64_t seed) {
  Random random(seed);
  SurfaceMesh leaves;
  for (int i = 0; i < 5; ++i) {
    const double radius = within(random, .22, .3) * size;
    const glm::dvec3 middle = around_y(circle * (i + random.unit()) / 5, i == 0 ? 0 : .2 * size, radius * .9);
    add_boulder(leaves, {middle, glm::dvec3(radius), 8, .5, 4, 4, random.next()});
  }
  return {{std::move(leaves), seed % 3 == 0 ? "young leaves" : "leaves"}};
}

std::vector<ModelPart> rock(double size, std::uint64_t seed) {
  Random random(seed);
  SurfaceMesh stone;
  const glm::dvec3 radii{within(random, .35, .5), within(random, .25, .4), within(random, .35, .5)};
  const std::size_t cells = 14 + random.below(13);
  add_boulder(stone, {{0, .6 * radii.y * size, 0}, radii * size, cells, .45, within(random, 1, 2), 5, random.next()});
  return {{std::move(stone), "stone"}};
}

std::vector<ModelPart> tuft(double size, std::uint64_t seed) {
  Random random(seed);
  SurfaceMesh blades;
  for (int blade = 0; blade < 90; ++blade) {
    const double angle = circle * random.unit(), bend = within(random, .05, .5), high = within(random, .5, 1);
    const double out = .25 * size * std::sqrt(random.unit());
    const glm::dvec3 root = around_y(circle * random.unit(), out, 0);
    const glm::dvec3 tip = root + around_y(angle, bend * size, high * size);
    const auto curve = bow(root, root + glm::dvec3(0, .7 * high * size, 0), tip);
    const glm::dvec3 side = around_y(angle + circle / 4, .018 * size, 0);
    add_grid(blades, 1, 8, [&](std::size_t i, std::size_t j) {
      const double t = static_cast<double>(j) / 8;
      return curve(t) + (i == 0 ? -1.0 : 1.0) * (1.02 - t) * side;
    });
  }
  return {{std::move(blades), "grass"}};
}

std::vector<ModelPart> street_piece(double height, std::uint64_t seed) {
  constexpr std::string_view materials[] = {"iron", "red paint", "green paint", "stone", "marble", "stone"};
  const std::uint64_t kind = seed % street_kinds;
  Random random(seed);
  std::vector<glm::dvec2> points = outline(kind);
  const double wide = within(random, .8, 1.2);
  for (glm::dvec2& point : points) point *= glm::dvec2(wide * height, height);
  const double flutes = static_cast<double>(6 + random.below(7)), deep = within(random, .01, .04);
  SurfaceMesh mesh;
  add_turned(mesh, {{},
                    polyline(std::move(points)),
                    48,
                    33,
                    [=](double angle, double way) { return way > .2 && way < .8 ? deep * wave(flutes * angle) : 0; },
                    {3, 3}});
  return {{std::move(mesh), materials[kind]}};
}

std::vector<ModelPart> statue(double height, std::uint64_t seed, std::size_t around, std::size_t along) {
  Random random(seed);
  std::vector<glm::dvec2> points = {{0, 0}, {.2, 0}, {.2, .12}, {.12, .15}};
  for (int i = 0; i < 5; ++i) points.emplace_back(within(random, .07, .17), .22 + .12 * i);
  points.insert(points.end(), {{.05, .82}, {.085, .9}, {.06, .98}, {0, 1}});
  for (glm::dvec2& point : points) point *= height;
  const double folds = static_cast<double>(3 + random.below(5)), twist = within(random, -1.5, 1.5);
  const std::uint64_t rough = random.next();
  SurfaceMesh mesh;
  add_turned(mesh, {{},
                    spline(std::move(points)),
                    around,
                    along,
                    [=](double angle, double way) {
                      if (way < .25) return 0.0;
                      const Turn turn = turn_by(circle * angle);
                      const double bumps = rough_noise({3 * turn.cosine, 12 * way, 3 * turn.sine}, 4, rough);
                      return .16 * wave(folds * angle + twist * way) + .22 * bumps;
                    },
                    {4, 4}});
  return {{std::move(mesh), "marble"}};
}

}  // namespace foredraw::bench
