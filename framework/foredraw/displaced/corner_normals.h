#pragma once
// Normals as sums over corners, weighted so that they hang neither on how many vertices there are nor on how a flat
// face is cut into triangles. N. Max: Weights for Computing Vertex Normals from Facet Normals, JGT 1999.

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace foredraw {

/// The normal of a triangle's face as its corner `a` counts it: as long as the sine of the angle there over the lengths
/// of the sides. 0 where the triangle has no area, or is not finite.
glm::dvec3 corner_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Replaces normals by faces': [vertex] the unit sum over the corners of all vertices of its group. It stays where that
/// sum is 0. `groups`: [vertex] the first vertex of its group. `indices`: a triangle list.
void replace_by_face_normals(std::span<glm::vec3> normals, std::span<const glm::vec3> positions,
                             std::span<const std::uint32_t> indices, std::span<const std::uint32_t> groups);

}  // namespace foredraw
