#pragma once
// The same scene, placed by EXT_mesh_gpu_instancing.

#include <foredraw/scene/scene.h>

namespace foredraw::bench {

/// One node for each mesh that nodes show, in the sequence in which they first do, with all its placements as
/// instances. The first `kept` nodes stay as they are; those behind them have no skin and no part in an animation,
/// and their placements are made of translation, rotation and scale: throws std::runtime_error where one shears.
Scene with_gpu_instancing(const Scene& scene, std::size_t kept = 0);

}  // namespace foredraw::bench
