#pragma once
// Noise in space and on a plane that repeats: the same on every machine.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace foredraw::bench {

/// Value noise (Perlin and Hoffert 1989 name it lattice value noise): random values from -1 to 1 at whole places,
/// smooth between them. `seed` chooses the values.
double noise(const glm::dvec3& place, std::uint64_t seed);

/// Sums of it, each half as high and twice as fine as the one before, divided by their greatest: from -1 to 1.
double rough_noise(const glm::dvec3& place, int octaves, std::uint64_t seed);

/// From 0 to 1, the same again one further along x or y; `cells` is how many random values there are to 1.
double tiled_noise(const glm::dvec2& place, const glm::ivec2& cells, int octaves, std::uint64_t seed);

}  // namespace foredraw::bench
