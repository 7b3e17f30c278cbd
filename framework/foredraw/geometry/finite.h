#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace foredraw {

/// True if every coordinate is finite.
template <glm::length_t n, class Number, glm::qualifier q>
bool is_finite(const glm::vec<n, Number, q>& vector) {
  for (glm::length_t i = 0; i < n; ++i) {
    if (!std::isfinite(vector[i])) return false;
  }
  return true;
}

template <class Vector, std::size_t n>
bool is_finite(const std::array<Vector, n>& vectors) {
  for (const Vector& vector : vectors) {
    if (!is_finite(vector)) return false;
  }
  return true;
}

/// True if every element is finite.
template <glm::length_t columns, glm::length_t rows, class Number, glm::qualifier q>
bool is_finite(const glm::mat<columns, rows, Number, q>& matrix) {
  for (glm::length_t i = 0; i < columns; ++i) {
    if (!is_finite(matrix[i])) return false;
  }
  return true;
}

}  // namespace foredraw
