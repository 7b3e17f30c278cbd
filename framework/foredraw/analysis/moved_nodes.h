#pragma once
// Which nodes do not stay where they are.

#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw {

/// [node] whether an animation moves it, or it is a joint, which a program may pose, or is below such a one.
std::vector<bool> moved_nodes(const Scene& scene);

}  // namespace foredraw
