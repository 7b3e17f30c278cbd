#pragma once
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <limits>

namespace foredraw {

/// An axis-aligned box of a vector type of GLM. Empty until something is added: its minimum is then infinity, its
/// maximum -infinity.
template <class Vector>
struct Box {
  using Number = typename Vector::value_type;

  Vector min{std::numeric_limits<Number>::infinity()};
  Vector max{-std::numeric_limits<Number>::infinity()};

  void add(const Vector& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void add(const Box& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }

  bool is_empty() const { return !(min.x <= max.x); }
  /// Lengths of its sides; 0 if it is empty.
  Vector extent() const { return is_empty() ? Vector(0) : max - min; }
  Number diagonal() const { return glm::length(extent()); }
};

}  // namespace foredraw
