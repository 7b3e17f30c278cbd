#pragma once
#include <glm/vec3.hpp>

#include <span>

namespace foredraw {

/// Of the box around the positions that are finite; 0 where none is.
double diagonal_of(std::span<const glm::vec3> positions);

}  // namespace foredraw
