#include "instance_transform.h"

#include <foredraw/geometry/finite.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// The axes of a matrix, or of what was made of it, do not differ by more than rounding does.
bool are_alike(const glm::dmat3& axes, const glm::mat4& composed) {
  double greatest = 0, difference = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      greatest = std::max(greatest, std::abs(axes[column][row]));
      difference = std::max(difference, std::abs(axes[column][row] - composed[column][row]));
    }
  }
  return difference <= 1e-6 * greatest;
}

}  // namespace

InstanceTransform instance_transform(const Node& node, bool is_root, const glm::mat4& world) {
  if (!is_finite(world)) return {{}, "their transforms are not finite"};
  if (world[0][3] != 0 || world[1][3] != 0 || world[2][3] != 0 || world[3][3] != 1) {
    return {{}, "their transforms are not affine"};
  }
  const glm::dmat3 axes(world);
  const glm::dvec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  const double volume = glm::dot(glm::cross(axes[0], axes[1]), axes[2]);
  // Elements are floats: below this part of the box that the axes could span, the sign is their rounding's.
  if (!(std::abs(volume) > 1e-6 * scale.x * scale.y * scale.z)) return {{}, "their transforms flatten them"};
  if (volume < 0) return {{}, "their transforms mirror them"};
  if (is_root && !node.matrix) return {node.transform, {}};

  Transform transform;
  transform.translation = glm::vec3(world[3]);
  const glm::dmat3 turned(axes[0] / scale.x, axes[1] / scale.y, axes[2] / scale.z);
  transform.rotation = glm::quat(glm::normalize(glm::quat_cast(turned)));
  transform.scale = glm::vec3(scale);
  if (!are_alike(axes, transform.matrix())) return {{}, "their transforms shear them"};
  return {transform, {}};
}

}  // namespace foredraw
