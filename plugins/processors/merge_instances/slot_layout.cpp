#include "slot_layout.h"

#include <algorithm>

namespace foredraw::processors::merge_instances {

namespace {

/// `groups`: how many draws one more frequency adds.
FrequencyChoice frequencies_of(std::span<const PackedMesh> meshes, std::span<const PlacedMesh> placed,
                               std::size_t groups, const MergeInstancesOptions& options) {
  std::vector<MeshSize> sizes;
  for (const PackedMesh& mesh : meshes) sizes.push_back({mesh.indices.size(), 0});
  for (const PlacedMesh& at : placed) sizes[at.mesh].placed += 1;
  FrequencyOptions wanted;
  wanted.multiple = static_cast<std::uint32_t>(std::max(0, options.multiple));
  wanted.classes = static_cast<std::uint32_t>(std::max(0, options.frequencies));
  wanted.padded_cost = options.padded_cost;
  wanted.slot_byte_cost = options.slot_byte_cost;
  // A padded entry is a call of the vertex shader, which a draw is priced in.
  wanted.class_cost = options.draw_cost * static_cast<double>(groups) * options.padded_cost;
  if (options.goal == FrequencyGoal::fewest_slots) {
    if (auto found = fewest_slots(sizes, options.most_padding, wanted)) return *found;
  }
  return best_frequencies(sizes, wanted);
}

SpatialGroups groups_of(std::span<const PackedMesh> meshes, std::span<const PlacedMesh> placed, std::size_t frequencies,
                        const MergeInstancesOptions& options, const Executor& executor) {
  std::vector<PlacedBox> boxes;
  boxes.reserve(placed.size());
  for (const PlacedMesh& at : placed) {
    boxes.push_back({at.box, static_cast<std::uint32_t>(meshes[at.mesh].indices.size())});
  }
  GroupOptions wanted;
  wanted.draw_cost = options.draw_cost * static_cast<double>(frequencies);
  wanted.most_indices = static_cast<std::uint64_t>(options.most_indices);
  wanted.most_instances = static_cast<std::uint32_t>(options.most_instances);
  wanted.most_size = options.most_size;
  wanted.view_distance = options.view_distance;
  return spatial_groups(boxes, wanted, executor);
}

}  // namespace

SlotLayout slot_layout(std::span<const PackedMesh> meshes, std::span<const PlacedMesh> placed,
                       const MergeInstancesOptions& options, const Executor& executor) {
  SlotLayout layout;
  layout.groups = groups_of(meshes, placed, 1, options, executor);
  layout.frequencies = frequencies_of(meshes, placed, layout.groups.size(), options);
  const std::size_t frequencies = layout.frequencies.frequencies.size();
  if (frequencies > 1) layout.groups = groups_of(meshes, placed, frequencies, options, executor);
  return layout;
}

}  // namespace foredraw::processors::merge_instances
