#pragma once
// Many meshes with many instances each, drawn as a few draws without a vertex stored twice. An engine that has no Scene
// takes the parts, which are plain functions: frequency.h, spatial_groups.h, packing.h, slot_order.h.

#include <foredraw/scene/merged_instances.h>

#include "mergeable.h"
#include "packing.h"
#include "spatial_groups.h"

namespace foredraw {

/// What the frequencies of slots are chosen for.
enum class FrequencyGoal : std::uint8_t {
  fewest_slots,  ///< as few slot records as a limit of padding allows
  least_cost,    ///< padding and records at their prices
};

struct MergeInstancesOptions {
  merging::SharedMaterials materials = merging::SharedMaterials::alike;
  bool skinned = false;     ///< skinned draws too; who draws them applies their joints
  Poses poses = rest_pose;  ///< that the boxes of skinned draws hold; the stage takes the pipeline's
  int multiple = 3;         ///< of the frequency, in index entries
  int frequencies = 2;      ///< of slots, at most, 1 to 4; each is a draw of each group
  FrequencyGoal goal = FrequencyGoal::fewest_slots;
  double most_padding = 0.02;             ///< of all entries drawn; goal fewest_slots
  double padded_cost = 12;                ///< bytes; goal least_cost
  double slot_byte_cost = 2;              ///< bytes; goal least_cost
  double draw_cost = 4096;                ///< of a draw call, in calls of the vertex shader
  std::int64_t most_indices = 1 << 24;    ///< of a group
  std::int64_t most_instances = 1 << 16;  ///< of a group
  double most_size = 0;                   ///< of a group's box, its longest side in the scene's units; 0: any
  double view_distance = 0;               ///< of cameras, in the scene's units; 0: a quarter of its diagonal
  bool cut_well = true;                   ///< cut meshes where few vertices are shared
};

/// Draws of one layout that one shader draws, merged.
struct MergedSet {
  merging::MergeableSet set;
  merging::FrequencyChoice frequencies;
  merging::SpatialGroups groups;                  ///< of set.placements
  std::shared_ptr<const VertexStreams> vertices;  ///< each mesh's once; those of other sets of this layout too
  std::vector<std::uint32_t> first_vertex;        ///< [mesh of the set]
  merging::PackedInstances packed;                ///< instances name set.placements
};

struct MergedScene {
  std::vector<MergedSet> merged;
  std::vector<merging::MergeableSet> not_merged;  ///< each with why_not
  std::vector<merging::LeftAlone> left_alone;
};

/// Merges what can be merged of `draws` (rising) and is worth it. The scene stays as it is. Deterministic at any number
/// of threads. Throws std::invalid_argument where an option makes no sense. Source: Persson, "Graphics Gems for Games",
/// SIGGRAPH 2012, "Merge-Instancing".
MergedScene merge_instances(const Scene& scene, std::span<const DrawId> draws, const MergeInstancesOptions& options,
                            const Executor& executor);

/// The last step of merge_instances(): what a set, of which all else is known, comes to in buffers.
merging::PackedInstances packed_instances(const Scene& scene, const MergedSet& set,
                                          const MergeInstancesOptions& options, const Executor& executor);

/// As the scene holds it.
MergedInstances merged_instances(const Scene& scene, const MergedSet& set);

struct Plugin;
Plugin merge_instances_plugin();

}  // namespace foredraw
