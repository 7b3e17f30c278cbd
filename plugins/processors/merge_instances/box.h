#pragma once
// Upright boxes in the world.

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <limits>

namespace foredraw::processors::merge_instances {

/// Empty until something is added.
struct Box {
  glm::vec3 least{std::numeric_limits<float>::infinity()};
  glm::vec3 most{-std::numeric_limits<float>::infinity()};

  void add(const glm::vec3& point) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  void add(const Box& other) {
    least = glm::min(least, other.least);
    most = glm::max(most, other.most);
  }
  bool is_empty() const { return !(least.x <= most.x); }
};

}  // namespace foredraw::processors::merge_instances
