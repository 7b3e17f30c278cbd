#pragma once
// Directions over the sphere, or over a part of it. The same bits on every machine.

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

using Directions = std::vector<glm::dvec3>;  ///< unit length

/// The vertices of an icosahedron, then of its refinements: each step halves every edge and lifts the middle onto the
/// sphere, so that the coarser set is the beginning of the finer one. `count`: 12, 42, 162, 642 or 2562.
Directions icosphere_directions(std::size_t count);

/// Points on a spiral from +Y towards -Y, each in the middle of its own slice of equal area (Swinbank and Purser 2006),
/// down to `angle` degrees from +Y; 180: all of the sphere.
Directions fibonacci_directions(std::size_t count, double angle = 180);

/// +X, -X, +Y, -Y, +Z, -Z.
Directions axis_directions();

/// Uniform on the sphere.
Directions random_directions(std::size_t count, std::uint64_t seed);

/// Turned so that what pointed to +Y points to `axis` (unit length).
Directions turned_to(const glm::dvec3& axis, std::span<const glm::dvec3> directions);

/// Turned all alike, by a rotation that is uniform over all rotations.
Directions turned_at_random(std::span<const glm::dvec3> directions, std::uint64_t seed);

glm::dvec3 normalised(const glm::dvec3& v);

/// Good to 1e-12, of angles up to a full circle.
double cosine_of_degrees(double angle);

}  // namespace foredraw
