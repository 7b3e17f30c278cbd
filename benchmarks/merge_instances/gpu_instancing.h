#pragma once
// The same scene, placed by EXT_mesh_gpu_instancing.

#include <foredraw/scene/scene.h>

namespace foredraw::bench {

/// One node for each mesh that nodes show, in the sequence in which they first do, with all its placements as
/// instances. Of scenes without skins and animations, whose placements are made of translation, rotation and scale;
/// throws std::runtime_error where a placement shears.
Scene with_gpu_instancing(const Scene& scene);

}  // namespace foredraw::bench
