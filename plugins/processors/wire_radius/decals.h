#pragma once
// Ribbons that are painted on something, and mouldings on a wall.

#include "wire_run.h"

#include <foredraw/analysis/ray_tree.h>

namespace foredraw::processors::wire_radius {

/// Lines at one place of a wire, that a surface which it belongs to would cross.
struct BackProbe {
  struct Line {
    glm::dvec3 from, to;
  };
  std::vector<Line> lines;    ///< one of them must be crossed,
  std::vector<Line> outside;  ///< but not all of these, as where there is a pipe in a pipe
};

/// Places along a run: before and behind of what is flat, and where a channel has no wall of its own, as far as `reach`
/// times its breadth; across a tube, within its walls.
std::vector<BackProbe> back_probes(const Chain& chain, const WireRun& run, double reach);
/// The same of a net.
std::vector<BackProbe> back_probes(const WeldedMesh& mesh, std::span<const std::uint32_t> triangles, double distance);

/// Whether at half of the places or more something is there.
bool is_decal(std::span<const BackProbe> probes, const RayTree& surfaces);

}  // namespace foredraw::processors::wire_radius
