#pragma once
// How long things are in the world: units of draws and of nodes may be anything.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw {

/// The largest diagonal of a draw's box as nodes and skins stretch it at rest; 0 where no node draws any of them.
double longest_diagonal(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses);

/// [node] how long a unit of its parent may be in the world, at rest or at any key of the animations. At least that:
/// the largest scales along the chain are multiplied. 0 where something above it is never larger than a point.
std::vector<double> longest_units(const Scene& scene);

}  // namespace foredraw
