#include "wire_sets.h"

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foredraw::bench {

namespace {

using Line = std::vector<glm::dvec3>;
using Outline = std::vector<glm::dvec2>;

constexpr double pi = std::numbers::pi;

double between(Random& random, double low, double high) { return low + (high - low) * random.unit(); }

Outline circle(std::uint32_t sides) {
  Outline outline;
  for (std::uint32_t i = 0; i < sides; ++i)
    outline.emplace_back(std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides));
  return outline;
}

Outline box(double width, double height) {
  return {{-width, -height}, {width, -height}, {width, height}, {-width, height}};
}

/// Half the least width over many directions.
double least_half_width(const Outline& outline) {
  double least = 1e300;
  for (int i = 0; i < 720; ++i) {
    const glm::dvec2 direction(std::cos(pi * i / 720), std::sin(pi * i / 720));
    double low = 1e300, high = -1e300;
    for (const glm::dvec2& at : outline) {
      low = std::min(low, glm::dot(at, direction));
      high = std::max(high, glm::dot(at, direction));
    }
    least = std::min(least, (high - low) / 2);
  }
  return least;
}

struct Sweep {
  bool closed_section = true, closed_line = false, caps = true;
  double roughness = 0;            ///< of the radius
  std::vector<double> scale = {};  ///< [point of the line]; empty: 1
  std::uint32_t wire = 0;
};

glm::dvec3 any_square_to(const glm::dvec3& way) {
  return glm::normalize(
      glm::cross(way, std::abs(way.y) < 0.8 * glm::length(way) ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
}

void add_triangle(KnownMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t wire) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
  mesh.wire_of.push_back(wire);
}

std::uint32_t add_vertex(KnownMesh& mesh, const glm::dvec3& at, const glm::dvec3& centre = glm::dvec3(0),
                         double half_width = 0) {
  mesh.positions.emplace_back(at);
  mesh.centre.push_back(centre);
  mesh.half_width.push_back(half_width);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// The outline along the line, its frames turned as little as can be. Answers with the first ring's first vertex.
std::uint32_t sweep(KnownMesh& mesh, const Line& line, const Outline& outline, const Sweep& how, Random& random) {
  const auto rings = static_cast<std::uint32_t>(line.size()), sides = static_cast<std::uint32_t>(outline.size());
  const double half =
      how.closed_section ? least_half_width(outline) : glm::distance(outline.front(), outline.back()) / 2;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  glm::dvec3 u(0);
  for (std::uint32_t r = 0; r < rings; ++r) {
    const glm::dvec3 before = r > 0             ? line[r] - line[r - 1]
                              : how.closed_line ? line[0] - line[rings - 1]
                                                : line[1] - line[0];
    const glm::dvec3 after = r + 1 < rings ? line[r + 1] - line[r] : how.closed_line ? line[0] - line[r] : before;
    const glm::dvec3 way = glm::normalize(glm::normalize(before) + glm::normalize(after));
    u = r == 0 ? any_square_to(way) : glm::normalize(u - way * glm::dot(u, way));
    const glm::dvec3 v = glm::cross(way, u);
    const double scale = how.scale.empty() ? 1 : how.scale[r];
    // At a mitre the section is stretched towards the bend.
    const double cosine = glm::dot(way, glm::normalize(after));
    const glm::dvec3 to_bend = glm::normalize(after) - glm::normalize(before);
    for (const glm::dvec2& at : outline) {
      glm::dvec3 off = scale * (1 + how.roughness * (2 * random.unit() - 1)) * (at.x * u + at.y * v);
      if (glm::length(to_bend) > 1e-6) {
        const glm::dvec3 bend = glm::normalize(to_bend);
        off += bend * glm::dot(off, bend) * (1 / cosine - 1);
      }
      add_vertex(mesh, line[r] + off, line[r], half * scale);
    }
  }
  for (std::uint32_t r = 0; r + (how.closed_line ? 0 : 1) < rings; ++r) {
    for (std::uint32_t s = 0; s + (how.closed_section ? 0 : 1) < sides; ++s) {
      const std::uint32_t next_ring = (r + 1) % rings, next = (s + 1) % sides;
      const std::uint32_t a = first + r * sides + s, b = first + r * sides + next, c = first + next_ring * sides + s,
                          d = first + next_ring * sides + next;
      add_triangle(mesh, a, b, d, how.wire);
      add_triangle(mesh, a, d, c, how.wire);
    }
  }
  for (const std::uint32_t ring : {0u, rings - 1}) {
    if (!how.caps || !how.closed_section || how.closed_line) break;
    for (std::uint32_t s = 1; s + 1 < sides; ++s) {
      const std::uint32_t a = first + ring * sides;
      ring == 0 ? add_triangle(mesh, a, a + s + 1, a + s, how.wire) : add_triangle(mesh, a, a + s, a + s + 1, how.wire);
    }
  }
  return first;
}

double length_of(const Line& line, bool closed = false) {
  double length = closed ? glm::distance(line.front(), line.back()) : 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
  return length;
}

/// As a hanging wire, but a parabola.
Line hanging(Random& random, std::uint32_t rings) {
  const glm::dvec3 from(between(random, -5, 0), between(random, 3, 5), between(random, -5, 5));
  const glm::dvec3 to(between(random, 4, 9), between(random, 3, 5), between(random, -5, 5));
  const double sag = between(random, 0.2, 2);
  Line line;
  for (std::uint32_t i = 0; i < rings; ++i) {
    const double t = static_cast<double>(i) / (rings - 1);
    line.push_back(from + (to - from) * t - glm::dvec3(0, 4 * sag * t * (1 - t), 0));
  }
  return line;
}

KnownMesh named(std::string name) {
  KnownMesh mesh;
  mesh.name = std::move(name);
  return mesh;
}

KnownMesh catenary(Random& random) {
  KnownMesh mesh = named("catenary");
  const Line line = hanging(random, 6 + static_cast<std::uint32_t>(random.below(60)));
  const auto sides = 3 + static_cast<std::uint32_t>(random.below(14));
  Outline outline = circle(sides);
  const double radius = between(random, 0.01, 0.1);
  for (glm::dvec2& at : outline) at *= radius;
  sweep(mesh, line, outline, {}, random);
  mesh.length = {length_of(line)};
  return mesh;
}

KnownMesh rough_wire(Random& random) {
  KnownMesh mesh = named("rough wire");
  const Line line = hanging(random, 80);
  Outline outline = circle(8);
  for (glm::dvec2& at : outline) at *= 0.05;
  sweep(mesh, line, outline, {.roughness = 0.1}, random);
  std::ranges::fill(mesh.half_width, 0);
  mesh.length = {length_of(line)};
  return mesh;
}

KnownMesh coil(Random& random) {
  KnownMesh mesh = named("coil");
  const double turns = between(random, 2, 6), radius = between(random, 0.5, 1), pitch = between(random, 0.3, 0.8);
  Line line;
  const auto rings = static_cast<int>(turns * 24);
  for (int i = 0; i <= rings; ++i) {
    const double angle = 2 * pi * turns * i / rings;
    line.emplace_back(radius * std::cos(angle), pitch * angle / (2 * pi), radius * std::sin(angle));
  }
  Outline outline = circle(6 + static_cast<std::uint32_t>(random.below(8)));
  for (glm::dvec2& at : outline) at *= 0.1 * pitch;
  sweep(mesh, line, outline, {}, random);
  mesh.length = {length_of(line)};
  return mesh;
}

KnownMesh ring(Random& random) {
  KnownMesh mesh = named("ring");
  Line line;
  const int rings = 12 + static_cast<int>(random.below(40));
  for (int i = 0; i < rings; ++i) line.emplace_back(std::cos(2 * pi * i / rings), 0, std::sin(2 * pi * i / rings));
  Outline outline = circle(8);
  const double radius = between(random, 0.03, 0.1);
  for (glm::dvec2& at : outline) at *= radius;
  sweep(mesh, line, outline, {.closed_line = true}, random);
  mesh.length = {length_of(line, true)};
  return mesh;
}

/// One mesh: a stout foot, a cone, the post, and a head that is welded on.
KnownMesh lamp_post(Random& random) {
  KnownMesh mesh = named("lamp post");
  const double r = between(random, 0.03, 0.06), height = between(random, 3, 6);
  const auto sides = 6 + static_cast<std::uint32_t>(random.below(7));
  const Line line = {{0, 0, 0},      {0, 0.6, 0},           {0, 0.65, 0},        {0, 0.7, 0}, {0, height - 0.05, 0},
                     {0, height, 0}, {0, height + 0.02, 0}, {0, height + 0.3, 0}};
  Outline outline = circle(sides);
  for (glm::dvec2& at : outline) at *= r;
  sweep(mesh, line, outline, {.scale = {3, 3, 1, 1, 1, 1, 4, 5}, .wire = no_wire}, random);
  for (std::uint32_t t = 0; t < 6 * sides; ++t) mesh.wire_of[2 * sides * 2 + t] = 0;
  for (std::uint32_t v = 0; v < mesh.half_width.size(); ++v) {
    if (v < 3 * sides || v >= 5 * sides) mesh.half_width[v] = 0;  // joints too
  }
  mesh.length = {height - 0.65};
  return mesh;
}

/// A rail on posts, each a tube of its own that reaches into the rail.
KnownMesh railing(Random& random) {
  KnownMesh mesh = named("railing");
  const double r = between(random, 0.02, 0.04), bay = between(random, 1, 1.5);
  const auto posts = 3 + static_cast<std::uint32_t>(random.below(4));
  Line rail;
  for (std::uint32_t i = 0; i < posts; ++i) rail.emplace_back(i * bay, 1, 0);
  Outline outline = random.below(2) == 0 ? box(r, r) : circle(8);
  if (outline.size() == 8) {
    for (glm::dvec2& at : outline) at *= r;
  }
  sweep(mesh, rail, outline, {}, random);
  mesh.length = {length_of(rail)};
  for (std::uint32_t i = 0; i < posts; ++i) {
    sweep(mesh, {{i * bay, 0, 0}, {i * bay, 1, 0}}, outline, {.wire = i + 1}, random);
    mesh.length.push_back(1);
  }
  return mesh;
}

/// An antenna welded on a body with a grid of triangles.
KnownMesh antenna(Random& random) {
  KnownMesh mesh = named("antenna on a body");
  const double r = between(random, 0.01, 0.03), height = between(random, 0.6, 1.2);
  const Line line = {{0, 0, 0}, {0, 0.3 * height, 0}, {0, 0.7 * height, 0}, {0, height, 0}};
  const std::uint32_t first = sweep(mesh, line, box(r, r), {.caps = false}, random);
  for (int i = 0; i < 4; ++i) mesh.half_width[static_cast<std::size_t>(i)] = 0;
  add_triangle(mesh, first + 12, first + 13, first + 14, 0);
  add_triangle(mesh, first + 12, first + 14, first + 15, 0);
  mesh.length = {height};
  // A pyramid's frustum below: rings of four that grow.
  std::uint32_t above = first;
  const double sizes[] = {0.2, 0.5, 0.9, 1};
  const double depths[] = {0, 0, -0.3, -0.9};
  for (int i = 0; i < 4; ++i) {
    const auto below = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t s = 0; s < 4; ++s) {
      const glm::dvec3 corner = glm::dvec3(mesh.positions[first + s]) * (sizes[i] / r);
      add_vertex(mesh, glm::dvec3(corner.x, depths[i], corner.z));
    }
    for (std::uint32_t s = 0; s < 4; ++s) {
      const std::uint32_t next = (s + 1) % 4;
      add_triangle(mesh, below + s, below + next, above + next, no_wire);
      add_triangle(mesh, below + s, above + next, above + s, no_wire);
    }
    above = below;
  }
  return mesh;
}

KnownMesh rope(Random& random) {
  KnownMesh mesh = named("flat rope");
  const Line line = hanging(random, 4 + static_cast<std::uint32_t>(random.below(30)));
  const double half = between(random, 0.01, 0.04);
  sweep(mesh, line, {{-half, 0}, {half, 0}}, {.closed_section = false}, random);
  mesh.length = {length_of(line)};
  return mesh;
}

/// Ribbons that cross, welded where they do.
KnownMesh net(Random& random) {
  KnownMesh mesh = named("net");
  const auto columns = 4 + static_cast<std::uint32_t>(random.below(4)),
             rows = 6 + static_cast<std::uint32_t>(random.below(10));
  const double half = between(random, 0.008, 0.015), step = 0.4;
  // Lines of vertices at both borders of each ribbon.
  const auto place = [&](std::uint32_t i) { return i / 2 * step + (i % 2 == 0 ? -half : half); };
  std::vector<std::uint32_t> number(4 * std::size_t{columns} * rows);
  for (std::uint32_t y = 0; y < 2 * rows; ++y) {
    for (std::uint32_t x = 0; x < 2 * columns; ++x) {
      number[y * 2 * columns + x] = add_vertex(mesh, {place(x), place(y), 0.3 * place(x) * place(x)});
    }
  }
  for (std::uint32_t y = 0; y + 1 < 2 * rows; ++y) {
    for (std::uint32_t x = 0; x + 1 < 2 * columns; ++x) {
      if (x % 2 == 1 && y % 2 == 1) continue;  // a hole
      const std::uint32_t a = number[y * 2 * columns + x], b = number[y * 2 * columns + x + 1];
      const std::uint32_t c = number[(y + 1) * 2 * columns + x], d = number[(y + 1) * 2 * columns + x + 1];
      add_triangle(mesh, a, b, d, 0);
      add_triangle(mesh, a, d, c, 0);
    }
  }
  mesh.length = {columns * (rows - 1) * step + rows * (columns - 1) * step};
  return mesh;
}

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

}  // namespace

std::vector<KnownMesh> made_meshes(std::uint64_t seed) {
  Random random(seed);
  std::vector<KnownMesh> all;
  for (int i = 0; i < 4; ++i) all.push_back(catenary(random));
  for (const auto make : {rough_wire, coil, ring, lamp_post, railing, antenna, rope, net}) {
    all.push_back(make(random));
    all.push_back(make(random));
  }
  for (const char* what : {"road marking", "plank", "bumper", "sword", "finger", "sail hem", "bar 5:1:1", "fat ring",
                           "egg", "blade of grass"}) {
    all.push_back(no_wires(random, what));
  }
  return all;
}

KnownMesh fine_tubes(std::uint32_t triangles) {
  Random random(1);
  KnownMesh mesh = named("fine tubes");
  constexpr std::uint32_t sides = 16, rings = 200;
  Outline outline = circle(sides);
  for (glm::dvec2& at : outline) at *= 0.05;
  for (std::uint32_t wire = 0; mesh.wire_of.size() < triangles; ++wire) {
    const Line line = hanging(random, rings);
    sweep(mesh, line, outline, {.wire = wire}, random);
    mesh.length.push_back(length_of(line));
  }
  return mesh;
}

KnownMesh hairs(std::uint32_t count) {
  Random random(1);
  KnownMesh mesh = named("hairs");
  for (std::uint32_t wire = 0; wire < count; ++wire) {
    const glm::dvec3 root(between(random, -1, 1), 0, between(random, -1, 1));
    const glm::dvec3 lean(between(random, -1, 1), 0, between(random, -1, 1));
    Line line;
    for (int i = 0; i <= 4; ++i) line.push_back(root + glm::dvec3(0, 0.25 * i, 0) + lean * (0.02 * i * i));
    sweep(mesh, line, {{-0.0005, 0}, {0.0005, 0}}, {.closed_section = false, .wire = wire}, random);
    mesh.length.push_back(1);
  }
  return mesh;
}

}  // namespace foredraw::bench
