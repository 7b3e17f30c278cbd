#include "made_kinds.h"

#include <algorithm>
#include <cmath>

namespace foredraw::bench::made {

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

}  // namespace foredraw::bench::made
