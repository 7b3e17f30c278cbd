#include "made_kinds.h"

#include <cmath>

namespace foredraw::bench::made {

namespace {

void add_bar(KnownMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, double width, double height,
             Random& random) {
  sweep(mesh, {from, to}, box(width / 2, height / 2), {.wire = no_wire}, random);
}

void add_sheet(KnownMesh& mesh, double width, double depth, std::uint32_t cells, double height) {
  std::vector<std::uint32_t> number;
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x)
      number.push_back(add_vertex(mesh, {width * x / cells, height * std::sin(3.0 * x / cells), depth * y / cells}));
  }
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t a = number[y * (cells + 1) + x], b = a + 1, c = a + cells + 1, d = c + 1;
      add_triangle(mesh, a, b, d, no_wire);
      add_triangle(mesh, a, d, c, no_wire);
    }
  }
}

}  // namespace

KnownMesh no_wires(Random& random, const std::string& what) {
  KnownMesh mesh = named(what);
  if (what == "road marking") {
    add_sheet(mesh, 10, 10, 8, 0);
    sweep(mesh, {{1, 0.01, 2}, {4, 0.01, 2}, {9, 0.01, 2}}, {{-0.06, 0}, {0.06, 0}},
          {.closed_section = false, .wire = no_wire}, random);
  } else if (what == "plank") {
    add_bar(mesh, {0, 0, 0}, {between(random, 3, 6), 0, 0}, 0.3, 0.05, random);
  } else if (what == "bumper") {
    sweep(mesh, {{-0.5, 0, 0.2}, {-0.4, 0, 0}, {0.4, 0, 0}, {0.5, 0, 0.2}}, box(0.12, 0.06), {.wire = no_wire}, random);
  } else if (what == "sword") {
    Outline blade = {{-0.04, 0}, {0, -0.008}, {0.04, 0}, {0, 0.008}};
    sweep(mesh, {{0, 0, 0}, {0, 0.9, 0}, {0, 1, 0}}, blade, {.scale = {1, 0.9, 0.05}, .wire = no_wire}, random);
    add_bar(mesh, {-0.12, 0, 0}, {0.12, 0, 0}, 0.04, 0.04, random);
    add_bar(mesh, {0, -0.2, 0}, {0, 0, 0}, 0.035, 0.03, random);
  } else if (what == "finger") {
    sweep(mesh, {{0, 0, 0}, {0, 0.3, 0.02}, {0, 0.5, 0.06}, {0, 0.68, 0.12}, {0, 0.72, 0.14}}, circle(10),
          {.scale = {0.09, 0.085, 0.08, 0.06, 0.02}, .wire = no_wire}, random);
  } else if (what == "sail hem") {
    add_sheet(mesh, 4, 3, 16, 0.5);
    Line edge;
    for (int x = 0; x <= 16; ++x) edge.emplace_back(4 * x / 16.0, 0.5 * std::sin(3 * x / 16.0) + 0.004, 0.03);
    sweep(mesh, edge, {{-0.03, 0}, {0.03, 0}}, {.closed_section = false, .wire = no_wire}, random);
  } else if (what == "bar 5:1:1") {
    add_bar(mesh, {0, 0, 0}, {1, 0, 0}, 0.2, 0.2, random);
  } else if (what == "fat ring") {
    Line line;
    for (int i = 0; i < 32; ++i) line.emplace_back(std::cos(2 * pi * i / 32), 0, std::sin(2 * pi * i / 32));
    Outline outline = circle(12);
    for (glm::dvec2& at : outline) at *= 0.5;
    sweep(mesh, line, outline, {.closed_line = true, .wire = no_wire}, random);
  } else if (what == "egg") {
    Line line;
    std::vector<double> scale;
    for (int i = 1; i < 24; ++i) {
      line.emplace_back(0, -std::cos(pi * i / 24) * 1.4, 0);
      scale.push_back(std::sin(pi * i / 24));
    }
    sweep(mesh, line, circle(32), {.scale = scale, .wire = no_wire}, random);
  } else if (what == "blade of grass") {
    sweep(mesh, {{0, 0, 0}, {0, 0.3, 0.02}, {0, 0.45, 0.06}}, {{-0.03, 0}, {0.03, 0}},
          {.closed_section = false, .scale = {1, 0.7, 0.05}, .wire = no_wire}, random);
  }
  return mesh;
}

}  // namespace foredraw::bench::made
