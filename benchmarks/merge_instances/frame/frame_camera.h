#pragma once
// Where a scene is looked at from.

#include <foredraw/scene/scene.h>

#include <glm/mat4x4.hpp>

namespace foredraw::bench {

/// What of the world a camera at `eye` sees that looks at `target` through 60 degrees, for Vulkan's clip space; +Y is
/// up.
glm::mat4 seen_from(const glm::vec3& eye, const glm::vec3& target, float nearest, float farthest);

struct SceneBounds {
  glm::vec3 least{0}, most{0};
};

/// Of all that placed_draws() shows: the box round each primitive's box.
SceneBounds bounds_of(const Scene& scene);

/// All of it, filling the picture and cut off nowhere, from above and from one side: `side` is how far the eye stands
/// from its middle along x and z, in diagonals.
glm::mat4 overview(const SceneBounds& bounds, const glm::vec2& side);

}  // namespace foredraw::bench
