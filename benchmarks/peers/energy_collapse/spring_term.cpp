#include "spring_term.h"

#include <glm/geometric.hpp>

namespace foredraw::processors::energy_collapse {

double spring_factor(double points_per_triangle) {
  return points_per_triangle < 4 ? 1e-2 : points_per_triangle < 8 ? 1e-4 : 1e-8;
}

double spring_term(const Star& star, const glm::dvec3& place, Fit& fit) {
  double sum = 0;
  for (const glm::dvec3& end : star.neighbours) {
    const glm::dvec3 edge = end - place;
    sum += glm::dot(edge, edge);
    fit.add(star.stiffness, 1, end);
  }
  return star.stiffness * sum;
}

}  // namespace foredraw::processors::energy_collapse
