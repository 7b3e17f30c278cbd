#pragma once
// How far a surface moves where an edge is collapsed.

#include "collapsing_mesh.h"

namespace foredraw::collapsing {

/// The largest distance, squared, that the corners involved come to lie from the other surface when both points go to
/// that place: the place from the faces that were around, and the points from those that will be. What is not above
/// `enough` need not be exact: 0 then.
double squared_deviation(const CollapsingMesh& mesh, std::uint32_t p, std::uint32_t q, glm::vec3 place, double enough);

}  // namespace foredraw::collapsing
