#include "merge_instances.h"

#include "packing.h"
#include "slot_layout.h"

#include <stdexcept>

namespace foredraw {

merging::PackedInstances merge_instances(std::span<const merging::PackedMesh> meshes,
                                         std::span<const merging::PlacedMesh> placed,
                                         const MergeInstancesOptions& options, const Executor& executor) {
  for (const merging::PlacedMesh& at : placed) {
    if (at.mesh >= meshes.size()) throw std::invalid_argument("a placed mesh is not among the meshes");
  }
  const merging::SlotLayout layout = merging::slot_layout(meshes, placed, options, executor);
  return merging::pack_instances(meshes, placed, layout.groups, layout.frequencies, {options.cut_well}, executor);
}

}  // namespace foredraw
