#pragma once
// Where a node stands, as an instance says it: translation, rotation, scale.

#include <foredraw/scene/scene.h>

#include <string_view>

namespace foredraw {

/// A transform of an instance, or why there is none.
struct InstanceTransform {
  Transform transform;
  std::string_view why_not;  ///< of nodes like this, a sentence; empty: the transform stands for it
};

/// Of a node whose transform to the world this is. A root with numbers of its own keeps them, bit by bit; others are
/// decomposed, rotation and scale exact to 1e-6 of the greatest scale, which no shear is. What is mirrored (a negative
/// determinant), flat, not affine or not finite has none.
InstanceTransform instance_transform(const Node& node, bool is_root, const glm::mat4& world);

}  // namespace foredraw
