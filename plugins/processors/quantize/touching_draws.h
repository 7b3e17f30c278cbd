#pragma once
// Which draws meet at vertices, and how far they come apart when their vertices are rounded.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <utility>
#include <vector>

namespace foredraw {

/// A vertex of a draw, as a node places it.
struct MetPoint {
  DrawId draw = 0;
  NodeId node = 0;
  std::uint32_t vertex = 0;
};

/// Points that lie on one another in the world: `at` the first, `with` one of another draw or node.
struct Meeting {
  MetPoint at, with;
};

/// Where vertices of what nodes place meet, within a millionth of the scene's diagonal. Each point meets the first one
/// that lies there. Full detail alone; skins, instances and morph targets move their draws otherwise, and are left out.
std::vector<Meeting> meetings_of(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses);

/// The largest distance in the world between two that met. [node] `drawn_by`: the node that draws its mesh now.
double largest_gap(const Scene& rounded, const std::vector<Meeting>& meetings, const std::vector<NodeId>& drawn_by,
                   Analyses& analyses);

}  // namespace foredraw
