#include "scalar_term.h"

#include <algorithm>

namespace foredraw::processors::energy_collapse {

namespace {

double of(const VertexScalars& scalars, std::uint32_t vertex, std::size_t k) {
  return static_cast<double>(scalars.values[vertex * scalars.width + k]);
}

/// What is missing if the kept vertex stays as it is, and what the whole blend would add.
struct Difference {
  double missing = 0, added = 0;
};

Difference difference(const StarTriangle& triangle, const glm::dvec3& weights, const VertexScalars& scalars,
                      std::span<const float> of_sample, std::size_t k) {
  const double kept = of(scalars, triangle.vertex[0], k);
  const double there = weights.x * kept + weights.y * of(scalars, triangle.vertex[1], k) +
                       weights.z * of(scalars, triangle.vertex[2], k);
  const double removed = triangle.removed == no_vertex ? kept : of(scalars, triangle.removed, k);
  return {static_cast<double>(of_sample[k]) - there, weights.x * (removed - kept)};
}

}  // namespace

double scalar_difference(const StarTriangle& triangle, const glm::dvec3& weights, double blend,
                         const VertexScalars& scalars, std::span<const float> of_sample) {
  double sum = 0;
  for (std::size_t k = 0; k < scalars.width; ++k) {
    const auto [missing, added] = difference(triangle, weights, scalars, of_sample, k);
    sum += (missing - blend * added) * (missing - blend * added);
  }
  return sum;
}

ScalarFit scalar_term(const Star& star, const std::vector<Nearest>& nearest, const VertexScalars& scalars,
                      std::span<const float> of_samples, double weight) {
  double squares = 0, across = 0, all = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const auto of_sample = of_samples.subspan(star.samples[i] * scalars.width, scalars.width);
    for (std::size_t k = 0; k < scalars.width; ++k) {
      const auto [missing, added] =
          difference(star.triangles[nearest[i].triangle], nearest[i].weights, scalars, of_sample, k);
      squares += added * added;
      across += added * missing;
      all += missing * missing;
    }
  }
  const double blend = squares > 0 ? std::clamp(across / squares, 0.0, 1.0) : 0.0;
  return {weight * (all - 2 * blend * across + blend * blend * squares), blend};
}

}  // namespace foredraw::processors::energy_collapse
