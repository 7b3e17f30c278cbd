#pragma once
// Of places between the steps of the texel grid.

#include <glm/vec2.hpp>

#include <limits>

namespace foredraw::processors::particle_trim {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace foredraw::processors::particle_trim
