#pragma once
// The sequence in which a file's nodes come: the only one that it has between its meshes.

#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw {

/// Every node once: before all that hangs below it, children in their sequence. Nodes without a parent come by number.
std::vector<NodeId> walk(const Scene& scene);

}  // namespace foredraw
