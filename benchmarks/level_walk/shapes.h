#pragma once
// Shapes that models are made of. Lengths are in the units of the scene; y is up.

#include "surface_mesh.h"

#include <foredraw/base/random.h>

#include <functional>
#include <vector>

namespace foredraw::bench {

constexpr double circle = 6.283185307179586;

inline double within(Random& random, double least, double most) { return least + (most - least) * random.unit(); }

/// A ball with a rough surface: 12 cells^2 triangles. `rough`: how far it goes up and down, as a part of its radius,
/// from 0 to below 1; `fine`: how many bumps there are to a radius.
struct Boulder {
  glm::dvec3 middle{0};
  glm::dvec3 radii{1};
  std::size_t cells = 16;
  double rough = 0.3;
  double fine = 1.5;
  int octaves = 4;
  std::uint64_t seed = 1;
};
void add_boulder(SurfaceMesh& to, const Boulder& boulder);

/// A box whose edges are round: 12 cells^2 triangles. `radius` is that of the edges, above 0 and at most the least
/// half.
void add_cushion(SurfaceMesh& to, const glm::dvec3& middle, const glm::dvec3& halves, double radius, std::size_t cells,
                 const glm::dvec2& repeats = glm::dvec2(1));

/// A box with edges: 12 triangles, texture coordinates in units of the scene.
void add_box(SurfaceMesh& to, const glm::dvec3& least, const glm::dvec3& most);

/// What a potter makes: a radius and a height for each part of the way, from 0 (below, or inside) to 1. `ripple`: how
/// much wider it is at an angle (0 to 1 round) and a part of the way, as a part of the radius.
struct Turning {
  glm::dvec3 foot{0};
  std::function<glm::dvec2(double)> profile;
  std::size_t around = 48, along = 48;
  std::function<double(double, double)> ripple = {};
  glm::dvec2 repeats{1};
};
void add_turned(SurfaceMesh& to, const Turning& turning);

/// A tube along a curve: where it is at a part of the way, 0 to 1, and how wide. `is_closed`: its end is its start.
struct Tube {
  std::function<glm::dvec3(double)> curve;
  std::function<double(double)> radius;
  std::size_t around = 12, along = 48;
  bool is_closed = false;
  glm::dvec2 repeats{1};
};
void add_tube(SurfaceMesh& to, const Tube& tube);

/// A curve through points that are given at equal parts of the way, in straight lines.
std::function<glm::dvec2(double)> polyline(std::vector<glm::dvec2> points);

/// As above, but smooth (Catmull and Rom 1974).
std::function<glm::dvec2(double)> spline(std::vector<glm::dvec2> points);

/// Like a sine, from -1 to 1, that repeats after 1: a parabola each way, above 0 from 0 to 0.5.
double wave(double part);

}  // namespace foredraw::bench
