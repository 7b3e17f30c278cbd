#include "distance_term.h"

#include <foredraw/analysis/closest_points.h>

#include <limits>

namespace foredraw::energy {

double distance_term(const Star& star, const glm::dvec3& place, double weight, std::vector<Nearest>& nearest,
                     Fit& fit) {
  nearest.resize(star.sample_at.size());
  double sum = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    Nearest best;
    best.squared = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < star.triangles.size(); ++t) {
      const auto& [a, b] = star.triangles[t].others;
      const Closest closest = closest_on({place, a, b}, star.sample_at[i]);
      const double squared = closest.distance * closest.distance;
      if (squared < best.squared) best = {t, closest.weights, squared};
    }
    const auto& [a, b] = star.triangles[best.triangle].others;
    fit.add(weight, best.weights.x, star.sample_at[i] - best.weights.y * a - best.weights.z * b);
    sum += best.squared;
    nearest[i] = best;
  }
  return weight * sum;
}

}  // namespace foredraw::energy
