#include "merge_instances.h"

#include "packing.h"
#include "slot_layout.h"

#include <stdexcept>

namespace foredraw {

processors::merge_instances::PackedInstances merge_instances(
    std::span<const processors::merge_instances::PackedMesh> meshes,
    std::span<const processors::merge_instances::PlacedMesh> placed, const MergeInstancesOptions& options,
    const Executor& executor) {
  for (const processors::merge_instances::PlacedMesh& at : placed) {
    if (at.mesh >= meshes.size()) throw std::invalid_argument("a placed mesh is not among the meshes");
  }
  const processors::merge_instances::SlotLayout layout =
      processors::merge_instances::slot_layout(meshes, placed, options, executor);
  return processors::merge_instances::pack_instances(meshes, placed, layout.groups, layout.frequencies,
                                                     {options.cut_well}, executor);
}

}  // namespace foredraw
