#pragma once
// Espring: edges pull, so that a place that the points leave open is found all the same.

#include "star.h"

namespace foredraw::processors::energy_collapse {

/// The factor of a spring where there are so many points of the original for each triangle: it falls as the mesh
/// becomes coarser, and points alone decide. Hoppe 1996, section 4.
double spring_factor(double points_per_triangle);

/// The sum of the squared lengths of the edges at the joined point, by the star's stiffness.
double spring_term(const Star& star, const glm::dvec3& place, Fit& fit);

}  // namespace foredraw::processors::energy_collapse
