#pragma once
// Edist: how far points of the original lie from the mesh.

#include "star.h"

namespace foredraw::processors::energy_collapse {

/// The sum of their squared distances, by `weight`, with the joined point at `place`. `nearest` gets [sample of the
/// star], and `fit` the squares that are left while each keeps its place on its triangle.
double distance_term(const Star& star, const glm::dvec3& place, double weight, std::vector<Nearest>& nearest, Fit& fit);

/// What points of the original do not see: a joined point that sticks out where none of them comes nearest to it. The
/// square of its distance from the nearest one, as far as that is above what the points' own distances, `squared` in
/// the mean, and their spacing allow, for the points of one triangle.
double overshoot_term(const Star& star, const glm::dvec3& place, double weight, double squared, double spacing);

}  // namespace foredraw::processors::energy_collapse
