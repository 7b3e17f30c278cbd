#pragma once
// From where to where rays are cast that ask whether a triangle is seen.

#include <foredraw/base/random.h>

#include <glm/vec3.hpp>

#include <array>

namespace foredraw {

/// Uniform over the sphere, of a length from 0.1 to 1.
glm::dvec3 random_direction(Random& random);

/// Uniform over the triangle, which is pulled inwards by a fiftieth, so that no ray begins on an edge.
glm::dvec3 random_point(const std::array<glm::dvec3, 3>& corners, Random& random);

}  // namespace foredraw
