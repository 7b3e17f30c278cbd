#pragma once
// Into slots of which sizes, and into which groups, placed meshes go: all that is chosen before a buffer is filled.

#include "frequency.h"
#include "merge_instances.h"
#include "spatial_groups.h"

namespace foredraw::processors::merge_instances {

struct SlotLayout {
  FrequencyChoice frequencies;
  SpatialGroups groups;
  std::size_t draws() const { return groups.size() * frequencies.frequencies.size(); }
};

/// A group is a draw of each frequency, so that the price of each choice hangs on the other: groups are found for one
/// frequency, frequencies for that many groups, and groups once more where they came to be several.
SlotLayout slot_layout(std::span<const PackedMesh> meshes, std::span<const PlacedMesh> placed,
                       const MergeInstancesOptions& options, const Executor& executor);

}  // namespace foredraw::processors::merge_instances
