#pragma once
// A mesh as an animation bends it, for simplifiers.

#include <foredraw/collapses/posed_vertices.h>
#include <foredraw/measuring/collapse_processor.h>
#include <foredraw/scene/poses.h>

namespace foredraw {

/// The mesh in at most that many of the poses, taken evenly by weight, as the first node shows it. Poses are scaled
/// alike, so that the surface is as large in the mean as at rest. No poses where no animation bends any of the draws,
/// where no node shows them, where all poses are at rest, or where something is not finite or has no area.
PosedVertices mesh_in_poses(const MeshInScene& of, const Poses& poses, std::size_t most);

}  // namespace foredraw
