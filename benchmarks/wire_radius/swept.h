#pragma once
// Outlines swept along lines: what made meshes consist of.

#include "wire_sets.h"

#include <foredraw/base/random.h>

#include <glm/vec2.hpp>

#include <numbers>
#include <string>
#include <vector>

namespace foredraw::bench::made {

using Line = std::vector<glm::dvec3>;
using Outline = std::vector<glm::dvec2>;

inline constexpr double pi = std::numbers::pi;

inline double between(Random& random, double low, double high) { return low + (high - low) * random.unit(); }

Outline circle(std::uint32_t sides);       ///< its corners at 1 from the middle
Outline box(double width, double height);  ///< half of what is wide and high

struct Sweep {
  bool closed_section = true, closed_line = false, caps = true;
  double roughness = 0;            ///< of the radius
  std::vector<double> scale = {};  ///< [point of the line]; empty: 1
  std::uint32_t wire = 0;
};

KnownMesh named(std::string name);

/// `wire`: its number, or no_wire.
void add_triangle(KnownMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t wire);

std::uint32_t add_vertex(KnownMesh& mesh, const glm::dvec3& at, const glm::dvec3& centre = glm::dvec3(0),
                         double half_width = 0);

/// The outline along the line, its frames turned as little as can be. Answers with the first ring's first vertex.
std::uint32_t sweep(KnownMesh& mesh, const Line& line, const Outline& outline, const Sweep& how, Random& random);

double length_of(const Line& line, bool closed = false);

/// As a hanging wire, but a parabola.
Line hanging(Random& random, std::uint32_t rings);

}  // namespace foredraw::bench::made
