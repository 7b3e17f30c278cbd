#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace foredraw {

inline double triangle_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::length(glm::cross(b - a, c - a)) / 2;
}

}  // namespace foredraw
