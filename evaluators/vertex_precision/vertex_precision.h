#pragma once
// How far packed vertices are from the plain streams beside them.

#include <foredraw/base/parallel.h>
#include <foredraw/packing/packed_precision.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/subject.h>

#include <optional>
#include <vector>

namespace foredraw {

/// Of posed vertices, as a skinning pass would write them.
struct PosedPrecision {
  double position = 0;         ///< largest error, in world units
  double bound = 0;            ///< what the layout promises
  double diagonal = 0;         ///< of the box over all poses of all draws with this lattice
  std::uint64_t outside = 0;   ///< vertices that the lattice does not reach, over all poses
  std::uint64_t vertices = 0;  ///< over all poses and nodes
};

struct DrawPrecision {
  DrawId draw = 0;
  PackedErrors errors;  ///< of the rows of full detail
  PackedBounds bounds;
  double diagonal = 0;  ///< of the box of the stored positions of all draws with this lattice
  std::optional<PosedPrecision> posed;
  std::uint64_t packed_bytes = 0, plain_bytes = 0;  ///< of what the rows hold
};

/// Of all packed draws, rising. The same at any number of threads.
std::vector<DrawPrecision> vertex_precision(const Scene& scene, SubjectUnit unit, const Poses& poses,
                                            const Executor& executor);

struct Plugin;
Plugin vertex_precision_plugin();

}  // namespace foredraw
