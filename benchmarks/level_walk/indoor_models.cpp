#include "indoor_models.h"

#include "outdoor_models.h"
#include "shapes.h"

#include <foredraw/base/random.h>
#include <foredraw/scene/turn.h>

namespace foredraw::bench {

namespace {

void add_leg(SurfaceMesh& to, const glm::dvec3& foot, double height, double radius) {
  const std::vector<glm::dvec2> points = {{0, 0},   {.7, 0},   {.9, .03}, {.6, .08}, {.7, .3}, {1.1, .42},
                                          {.7, .5}, {.9, .75}, {1, .85},  {1.3, .9}, {1.3, 1}, {0, 1}};
  std::vector<glm::dvec2> sized;
  for (const glm::dvec2& point : points) sized.push_back(point * glm::dvec2(radius, height));
  add_turned(to, {foot, spline(std::move(sized)), 24, 56, {}, {1, 3}});
}

void add_legs(SurfaceMesh& to, double half_width, double half_depth, double height, double radius) {
  for (const double x : {-half_width, half_width}) {
    for (const double z : {-half_depth, half_depth}) add_leg(to, {x, 0, z}, height, radius);
  }
}

}  // namespace

std::vector<ModelPart> table() {
  SurfaceMesh wood;
  add_cushion(wood, {0, .77, 0}, {.7, .03, .4}, .025, 18, {2, 1});
  add_legs(wood, .6, .3, .74, .035);
  return {{std::move(wood), "planks"}};
}

std::vector<ModelPart> chair(std::uint64_t seed) {
  SurfaceMesh wood, cloth;
  add_legs(wood, .2, .2, .44, .022);
  for (const double x : {-.21, .21}) add_cushion(wood, {x, .72, -.21}, {.022, .28, .022}, .02, 6, {1, 2});
  for (int bar = 0; bar < 3; ++bar) add_cushion(wood, {0, .62 + .15 * bar, -.21}, {.2, .03, .012}, .011, 6, {2, 1});
  add_cushion(cloth, {0, .47, 0}, {.25, .045, .25}, .04, 12);
  return {{std::move(wood), "planks"}, {std::move(cloth), seed % 2 == 0 ? "cloth" : "red cloth"}};
}

std::vector<ModelPart> sofa(std::uint64_t seed) {
  SurfaceMesh cloth, wood;
  add_cushion(cloth, {0, .26, 0}, {.83, .14, .4}, .06, 14, {4, 2});
  add_cushion(cloth, {0, .6, -.32}, {.83, .25, .1}, .09, 14, {4, 2});
  for (const double x : {-.76, .76}) add_cushion(cloth, {x, .4, .02}, {.09, .22, .4}, .08, 12, {2, 2});
  for (const double x : {-.34, .34}) add_cushion(cloth, {x, .45, .06}, {.33, .08, .33}, .07, 14, {2, 2});
  for (const double x : {-.7, .7}) {
    for (const double z : {-.3, .3}) add_cushion(wood, {x, .06, z}, {.04, .06, .04}, .03, 4);
  }
  return {{std::move(cloth), seed % 2 == 0 ? "red cloth" : "cloth"}, {std::move(wood), "planks"}};
}

std::vector<ModelPart> shelf(std::uint64_t seed) {
  Random random(seed);
  SurfaceMesh wood, books[3];
  for (const double x : {-.58, .58}) add_cushion(wood, {x, .9, 0}, {.02, .9, .17}, .01, 5, {1, 4});
  for (int board = 0; board < 5; ++board) {
    const double height = .04 + .44 * board;
    add_cushion(wood, {0, height, 0}, {.56, .018, .16}, .01, 5, {3, 1});
    if (board == 4) continue;
    for (double x = -.54; x < .46;) {
      const double thick = within(random, .02, .05), high = within(random, .12, .18), deep = within(random, .09, .12);
      if (random.unit() < .85) {
        add_cushion(books[random.below(3)], {x + thick / 2, height + .02 + high, .02}, {thick / 2, high, deep},
                    thick * .2, 3);
      }
      x += thick + .004;
    }
  }
  return {{std::move(wood), "planks"},
          {std::move(books[0]), "red paint"},
          {std::move(books[1]), "green paint"},
          {std::move(books[2]), "blue glaze"}};
}

std::vector<ModelPart> pedestal() {
  SurfaceMesh marble;
  const auto profile = polyline({{0, 0},
                                 {.22, 0},
                                 {.22, .08},
                                 {.16, .12},
                                 {.15, .2},
                                 {.14, .5},
                                 {.13, .82},
                                 {.18, .88},
                                 {.22, .92},
                                 {.22, 1},
                                 {0, 1}});
  add_turned(marble, {{},
                      profile,
                      72,
                      42,
                      [](double angle, double way) { return way > .35 && way < .7 ? .05 * wave(12 * angle) : 0; },
                      {3, 3}});
  return {{std::move(marble), "marble"}};
}

std::vector<ModelPart> vase(std::uint64_t seed) {
  Random random(seed);
  const double height = within(random, .35, .5), belly = within(random, .1, .15), neck = within(random, .03, .06);
  const double ribs = static_cast<double>(8 + random.below(12)), twist = within(random, -1, 1);
  SurfaceMesh mesh;
  add_turned(mesh, {{},
                    spline({{0, 0},
                            {.07, 0},
                            {.075, .02},
                            {belly, .45 * height},
                            {belly * .8, .7 * height},
                            {neck, .85 * height},
                            {neck * 1.6, height},
                            {neck, .9 * height},
                            {neck, .8 * height},
                            {0, .78 * height}}),
                    96,
                    64,
                    [=](double angle, double way) {
                      return way > .2 && way < .65 ? .04 * wave(ribs * (angle + twist * way)) : 0;
                    },
                    {3, 2}});
  return {{std::move(mesh), seed % 2 == 0 ? "white glaze" : "blue glaze"}};
}

std::vector<ModelPart> floor_lamp() {
  SurfaceMesh brass, shade;
  add_turned(brass,
             {{},
              polyline({{0, 0}, {.16, 0}, {.16, .02}, {.05, .05}, {.015, .12}, {.015, 1.25}, {.03, 1.3}, {0, 1.35}}),
              32,
              56,
              {},
              {1, 1}});
  add_turned(shade, {{},
                     polyline({{.12, 1.6}, {.115, 1.6}, {.215, 1.3}, {.225, 1.3}, {.22, 1.32}, {.12, 1.6}}),
                     72,
                     25,
                     [](double angle, double) { return .02 * wave(24 * angle); },
                     {6, 1}});
  return {{std::move(brass), "brass"}, {std::move(shade), "red cloth"}};
}

std::vector<ModelPart> pot_plant(std::uint64_t seed) {
  std::vector<ModelPart> parts = tree(1.15, seed);
  for (ModelPart& part : parts) {
    for (glm::vec3& place : part.mesh.places) place.y += .2f;
  }
  SurfaceMesh pot;
  add_turned(
      pot, {{},
            polyline({{0, 0}, {.14, 0}, {.15, .04}, {.2, .3}, {.22, .31}, {.22, .35}, {.19, .35}, {.18, .3}, {0, .29}}),
            72,
            60,
            [](double angle, double way) { return way > .3 && way < .5 ? .03 * wave(18 * angle) : 0; },
            {3, 1}});
  parts.push_back({std::move(pot), "blue glaze"});
  return parts;
}

std::vector<ModelPart> chandelier(std::uint64_t seed) {
  SurfaceMesh brass, glass;
  add_turned(brass, {{0, -.7, 0},
                     spline({{0, 0}, {.03, .01}, {.08, .1}, {.03, .2}, {.02, .5}, {.05, .62}, {.1, .68}, {0, .7}}),
                     32,
                     48,
                     {},
                     {1, 1}});
  const std::uint64_t arms = 6 + seed % 3 * 2;
  for (std::uint64_t arm = 0; arm < arms; ++arm) {
    const Turn turn = turn_by(circle * static_cast<double>(arm) / static_cast<double>(arms));
    const auto curve = [=](double t) {
      const double out = .05 + .4 * t, height = -.55 - .6 * t * (1 - t) + .1 * t;
      return glm::dvec3(out * turn.cosine, height, out * turn.sine);
    };
    add_tube(brass, {curve, [](double t) { return .014 - .006 * t; }, 16, 48, false, {1, 4}});
    const glm::dvec3 end = curve(1);
    add_turned(glass, {end,
                       spline({{0, 0}, {.02, 0}, {.05, .04}, {.04, .1}, {.045, .12}, {.035, .1}, {0, .02}}),
                       32,
                       32,
                       [](double angle, double) { return .05 * wave(8 * angle); },
                       {1, 1}});
  }
  return {{std::move(brass), "brass"}, {std::move(glass), "white glaze"}};
}

std::vector<ModelPart> rug(std::uint64_t seed) {
  SurfaceMesh cloth;
  add_cushion(cloth, {0, .015, 0}, {.95, .015, .65}, .014, 20, {4, 3});
  return {{std::move(cloth), seed % 2 == 0 ? "red cloth" : "cloth"}};
}

std::vector<ModelPart> slab(const glm::dvec3& size, std::string_view material) {
  SurfaceMesh mesh;
  add_box(mesh, {-size.x / 2, 0, -size.z / 2}, {size.x / 2, size.y, size.z / 2});
  return {{std::move(mesh), material}};
}

}  // namespace foredraw::bench
