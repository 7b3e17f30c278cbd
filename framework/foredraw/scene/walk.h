#pragma once
// The sequence in which a file's nodes come: the only one that it has between its meshes.

#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw {

/// Nodes without a parent: those that the scene names, in its sequence, then the others by number.
std::vector<NodeId> roots_of(const Scene& scene);

/// Every node once: before all that hangs below it, roots and children in their sequence.
std::vector<NodeId> walk(const Scene& scene);

}  // namespace foredraw
