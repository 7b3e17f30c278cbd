#pragma once
// Escalar: how far attributes at points of the original differ from those where the mesh comes nearest.

#include "energy_collapse.h"
#include "star.h"

namespace foredraw::processors::energy_collapse {

struct ScalarFit {
  double energy = 0;
  double blend = 0;  ///< of the joined vertices: from the kept ones to the removed ones, 0 to 1
};

/// The blend for which the sum of squared differences is least, a linear least squares problem as the places stay, and
/// that sum by `weight`. `of_samples` holds the original's, [sample * width].
ScalarFit scalar_term(const Star& star, const std::vector<Nearest>& nearest, const VertexScalars& scalars,
                      std::span<const float> of_samples, double weight);

/// The same sum for a blend, of one sample.
double scalar_difference(const StarTriangle& triangle, const glm::dvec3& weights, double blend,
                         const VertexScalars& scalars, std::span<const float> of_sample);

}  // namespace foredraw::processors::energy_collapse
