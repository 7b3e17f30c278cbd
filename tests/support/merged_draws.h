#pragma once
// Merged draws put together in the plainest way, for tests of who writes, reads or counts them: no slot is shared out
// with care.

#include <foredraw/instances/merged_instances.h>
#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw::testing {

/// Every primitive of every node that shows a mesh, as often as the node places it.
std::vector<MergedPlace> all_places(const Scene& scene);

struct MergeByHand {
  std::vector<std::uint32_t> frequencies{6};  ///< the k-th draw has the k-th, in turns
  std::uint32_t groups = 2;                   ///< places are shared out in their sequence
  bool materials = false;                     ///< instances have their own
};

/// The places' draws, which must have one vertex layout and be lists of triangles.
MergedInstances merged_by_hand(const Scene& scene, const std::vector<MergedPlace>& places, const MergeByHand& how = {});

/// The scene with them, as a stage would leave it behind.
Scene with_merged(Scene scene, const std::vector<MergedInstances>& merged);

inline std::vector<MergedInstances> merged_of(const Scene& scene) {
  const auto sets = merged_sets(scene);
  return {sets.begin(), sets.end()};
}

}  // namespace foredraw::testing
