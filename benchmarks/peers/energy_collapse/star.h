#pragma once
// What lies around a joined point: what the terms of the energy are made of.

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace foredraw::processors::energy_collapse {

inline constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

/// A triangle that stays: the joined point is its first corner.
struct StarTriangle {
  std::uint32_t number = 0;               ///< of the mesh
  std::array<glm::dvec3, 2> others{};     ///< its other corners, in its direction
  std::array<std::uint32_t, 3> vertex{};  ///< at its corners; the first is one of the kept point
  std::uint32_t removed = no_vertex;      ///< the vertex of the removed point that pairs with the first one, if any
  glm::dvec3 normal{0};                   ///< before, of twice its area
};

/// Where the surface comes nearest to a point of the original.
struct Nearest {
  std::uint32_t triangle = 0;  ///< of the star
  glm::dvec3 weights{0};       ///< of the corners
  double squared = 0;          ///< distance
};

struct Star {
  std::vector<StarTriangle> triangles;
  std::vector<std::uint32_t> samples, curve_samples;  ///< numbers of the original's points, of its surface and curves
  std::vector<glm::dvec3> sample_at, curve_at;        ///< where those are
  std::vector<glm::dvec3> neighbours;                 ///< ends of the edges that will be there
  std::vector<std::uint32_t> curve_ends;              ///< points that borders and seams lead to
  std::vector<glm::dvec3> curve_end_at;               ///< where those are
  double before = 0;                                  ///< the energy of all that before, weighted
  double stiffness = 0;                               ///< of its springs, weighted
};

/// The place at which a sum of squares |coefficient * place - target|^2 is least.
struct Fit {
  double matrix = 0;
  glm::dvec3 vector{0};

  void add(double weight, double coefficient, const glm::dvec3& target) {
    matrix += weight * coefficient * coefficient;
    vector += weight * coefficient * target;
  }
};

}  // namespace foredraw::processors::energy_collapse
