#pragma once
// Positions that are whole numbers, brought back to where they were by what places them.

#include "integer_positions.h"

#include <optional>
#include <vector>

namespace foredraw {

/// Nodes, instances and skins take in the grids [draw], and so do the lengths of materials, of which copies are made
/// where draws of several grids have one. A node that something may move, or that has a name by which a program may
/// find it, stays where it is: a new child draws its mesh, before its other children. Answers with the node that draws
/// each node's mesh now.
std::vector<NodeId> scale_back(Scene& scene, const std::vector<std::optional<PositionGrid>>& grids);

}  // namespace foredraw
