#include "shapes.h"

#include "solid_noise.h"

#include <foredraw/scene/turn.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::bench {

namespace {

double part(std::size_t i, std::size_t count) { return static_cast<double>(i) / static_cast<double>(count); }

glm::dvec3 unit(const glm::dvec3& vector) { return vector / std::sqrt(glm::dot(vector, vector)); }

/// The point before a part of the way, and how far it is from there to the next one.
struct Between {
  std::size_t point;
  double rest;
};
Between place_between(double t, std::size_t points) {
  const double along = std::clamp(t, 0.0, 1.0) * static_cast<double>(points - 1);
  const std::size_t point = std::min(static_cast<std::size_t>(along), points - 2);
  return {point, along - static_cast<double>(point)};
}

}  // namespace

void add_boulder(SurfaceMesh& to, const Boulder& boulder) {
  add_cube(to, boulder.cells, [&](const glm::dvec3& cube) {
    const glm::dvec3 way = unit(cube);
    const double bump = rough_noise(boulder.fine * way + glm::dvec3(17.5), boulder.octaves, boulder.seed);
    return boulder.middle + boulder.radii * way * (1 + boulder.rough * bump);
  });
}

void add_cushion(SurfaceMesh& to, const glm::dvec3& middle, const glm::dvec3& halves, double radius, std::size_t cells,
                 const glm::dvec2& repeats) {
  const glm::dvec3 inner = halves - radius;
  add_cube(
      to, cells,
      [&](const glm::dvec3& cube) {
        const glm::dvec3 at = cube * halves, held = glm::clamp(at, -inner, inner);
        return middle + held + radius * unit(at - held);
      },
      repeats);
}

void add_box(SurfaceMesh& to, const glm::dvec3& least, const glm::dvec3& most) {
  const glm::dvec3 size = most - least;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_far : {true, false}) {
      const int u = (axis + (is_far ? 1 : 2)) % 3, v = (axis + (is_far ? 2 : 1)) % 3;
      add_grid(to, 1, 1,
               [&](std::size_t i, std::size_t j) {
                 glm::dvec3 at = least;
                 if (is_far) at[axis] = most[axis];
                 if (i == 1) at[u] = most[u];
                 if (j == 1) at[v] = most[v];
                 return at;
               },
               {size[u], size[v]});
    }
  }
}

void add_turned(SurfaceMesh& to, const Turning& turning) {
  add_grid(
      to, turning.around, turning.along,
      [&](std::size_t i, std::size_t j) {
        const double angle = part(i % turning.around, turning.around), way = part(j, turning.along);
        const glm::dvec2 at = turning.profile(way);
        const Turn turn = turn_by(-circle * angle);
        const double radius = at.x * (turning.ripple ? 1 + turning.ripple(angle, way) : 1);
        return turning.foot + glm::dvec3(radius * turn.cosine, at.y, radius * turn.sine);
      },
      turning.repeats);
}

void add_tube(SurfaceMesh& to, const Tube& tube) {
  add_grid(
      to, tube.around, tube.along,
      [&](std::size_t i, std::size_t j) {
        const double way = part(tube.is_closed ? j % tube.along : j, tube.along);
        const double ahead = 0.25 / static_cast<double>(tube.along);
        const auto place = [&](double t) { return tube.curve(tube.is_closed ? t - std::floor(t) : t); };
        const glm::dvec3 along = unit(place(way + ahead) - place(way - ahead));
        const glm::dvec3 aside = unit(glm::dvec3(0.31, 0.17, 0.93));
        const glm::dvec3 right = unit(glm::cross(aside, along)), up = glm::cross(along, right);
        const Turn turn = turn_by(circle * part(i % tube.around, tube.around));
        return tube.curve(way) + tube.radius(way) * (turn.cosine * right + turn.sine * up);
      },
      tube.repeats);
}

std::function<glm::dvec2(double)> polyline(std::vector<glm::dvec2> points) {
  return [points = std::move(points)](double t) {
    const auto [i, rest] = place_between(t, points.size());
    return points[i] + rest * (points[i + 1] - points[i]);
  };
}

std::function<glm::dvec2(double)> spline(std::vector<glm::dvec2> points) {
  return [points = std::move(points)](double t) {
    const auto [i, x] = place_between(t, points.size());
    const glm::dvec2 b = points[i], c = points[i + 1];
    const glm::dvec2 a = i == 0 ? b : points[i - 1], d = i + 2 == points.size() ? c : points[i + 2];
    glm::dvec2 at = 0.5 * (2.0 * b + (c - a) * x + (2.0 * a - 5.0 * b + 4.0 * c - d) * x * x +
                           (3.0 * b - a - 3.0 * c + d) * x * x * x);
    at.x = std::max(at.x, 0.0);  // a radius, which a curve may swing below
    return at;
  };
}

double wave(double part) {
  const double x = 2 * (part - std::floor(part));
  return x < 1 ? 4 * x * (1 - x) : -4 * (x - 1) * (2 - x);
}

}  // namespace foredraw::bench
