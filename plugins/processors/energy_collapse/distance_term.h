#pragma once
// Edist: how far points of the original lie from the mesh.

#include "star.h"

namespace foredraw::energy {

/// The sum of their squared distances, by `weight`, with the joined point at `place`. `nearest` gets [sample of the
/// star], and `fit` the squares that are left while each keeps its place on its triangle.
double distance_term(const Star& star, const glm::dvec3& place, double weight, std::vector<Nearest>& nearest, Fit& fit);

}  // namespace foredraw::energy
