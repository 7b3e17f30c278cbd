#pragma once
// What of a scene is merged: the draws that share a layout and a shader, each set as merged draws.

#include "merge_instances.h"
#include "mergeable.h"
#include "slot_layout.h"

namespace foredraw {

struct MergeSceneOptions : MergeInstancesOptions {
  processors::merge_instances::SharedMaterials materials = processors::merge_instances::SharedMaterials::alike;
  bool skinned = false;     ///< skinned draws too; who draws them applies their joints
  Poses poses = rest_pose;  ///< that the boxes of skinned draws hold; the stage takes the pipeline's
};

/// Draws of one layout that one shader draws, merged.
struct MergedSet {
  processors::merge_instances::MergeableSet set;
  processors::merge_instances::SlotLayout layout;       ///< of set.placements
  std::shared_ptr<const VertexStreams> vertices;        ///< each mesh's once; those of other sets of this layout too
  std::vector<std::uint32_t> first_vertex;              ///< [mesh of the set]
  processors::merge_instances::PackedInstances packed;  ///< instances name set.placements
};

struct MergedScene {
  std::vector<MergedSet> merged;
  std::vector<processors::merge_instances::MergeableSet> not_merged;  ///< each with why_not
  std::vector<processors::merge_instances::LeftAlone> left_alone;
};

/// Merges what can be merged of `draws` (rising) and is worth it. The scene stays as it is. Deterministic at any number
/// of threads. Throws std::invalid_argument where an option makes no sense.
MergedScene merge_scene(const Scene& scene, std::span<const DrawId> draws, const MergeSceneOptions& options,
                        const Executor& executor);

/// The last step of merge_scene(): what a set, of which all else is known, comes to in buffers.
processors::merge_instances::PackedInstances packed_instances(const Scene& scene, const MergedSet& set,
                                                              const MergeInstancesOptions& options,
                                                              const Executor& executor);

/// As the scene holds it.
MergedInstances merged_instances(const Scene& scene, const MergedSet& set);

}  // namespace foredraw
