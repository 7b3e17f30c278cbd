#include "swept.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::bench::made {

namespace {

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

glm::dvec3 any_square_to(const glm::dvec3& way) {
  return glm::normalize(
      glm::cross(way, std::abs(way.y) < 0.8 * glm::length(way) ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
}

}  // namespace

Outline circle(std::uint32_t sides) {
  Outline outline;
  for (std::uint32_t i = 0; i < sides; ++i)
    outline.emplace_back(std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides));
  return outline;
}

Outline box(double width, double height) {
  return {{-width, -height}, {width, -height}, {width, height}, {-width, height}};
}

void add_triangle(KnownMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t wire) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
  mesh.wire_of.push_back(wire);
}

std::uint32_t add_vertex(KnownMesh& mesh, const glm::dvec3& at, const glm::dvec3& centre, double half_width) {
  mesh.positions.emplace_back(at);
  mesh.centre.push_back(centre);
  mesh.half_width.push_back(half_width);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

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

double length_of(const Line& line, bool closed) {
  double length = closed ? glm::distance(line.front(), line.back()) : 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
  return length;
}

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

}  // namespace foredraw::bench::made
