#include "merge_instances.h"

#include "shared_vertices.h"

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

using merging::FrequencyChoice;
using merging::MergeableSet;
using merging::MeshSize;

/// `groups`: how many draws one more frequency adds.
FrequencyChoice frequencies_of(const MergeableSet& set, std::size_t groups, const MergeInstancesOptions& options) {
  std::vector<MeshSize> sizes;
  for (const merging::MergeableMesh& mesh : set.meshes) sizes.push_back({mesh.indices, mesh.placed});
  merging::FrequencyOptions wanted;
  wanted.multiple = static_cast<std::uint32_t>(std::max(0, options.multiple));
  wanted.classes = static_cast<std::uint32_t>(std::max(0, options.frequencies));
  wanted.padded_cost = options.padded_cost;
  wanted.slot_byte_cost = options.slot_byte_cost;
  // A padded entry is a call of the vertex shader, which a draw is priced in.
  wanted.class_cost = options.draw_cost * static_cast<double>(groups) * options.padded_cost;
  if (options.goal == FrequencyGoal::fewest_slots) {
    if (auto found = merging::fewest_slots(sizes, options.most_padding, wanted)) return *found;
  }
  return merging::best_frequencies(sizes, wanted);
}

/// Every group is a draw of each frequency.
merging::SpatialGroups groups_of(const MergeableSet& set, std::size_t frequencies, const MergeInstancesOptions& options,
                                 const Executor& executor) {
  std::vector<merging::PlacedBox> boxes;
  boxes.reserve(set.placements.size());
  for (const merging::MergeablePlacement& placement : set.placements) {
    boxes.push_back({placement.box, static_cast<std::uint32_t>(set.meshes[placement.mesh].indices)});
  }
  merging::GroupOptions wanted;
  wanted.draw_cost = options.draw_cost * static_cast<double>(frequencies);
  wanted.most_indices = static_cast<std::uint64_t>(options.most_indices);
  wanted.most_instances = static_cast<std::uint32_t>(options.most_instances);
  wanted.most_size = options.most_size;
  wanted.view_distance = options.view_distance;
  return merging::spatial_groups(boxes, wanted, executor);
}

/// Of the nodes: one that draws a mesh many times takes one draw for it.
std::uint64_t plain_draws(const MergeableSet& set) {
  std::vector<std::pair<NodeId, std::uint32_t>> drawn;
  drawn.reserve(set.placements.size());
  for (const merging::MergeablePlacement& placement : set.placements) {
    drawn.push_back({placement.place.node, placement.place.primitive});
  }
  std::ranges::sort(drawn);
  return static_cast<std::uint64_t>(std::unique(drawn.begin(), drawn.end()) - drawn.begin());
}

/// What is known only when slots and groups are: whether the draws that are saved are worth what the shader does more.
std::string why_not_worth_it(const MergeableSet& set, const FrequencyChoice& frequencies, std::size_t groups,
                             const MergeInstancesOptions& options) {
  const std::uint64_t before = plain_draws(set);
  const std::uint64_t after = groups * frequencies.frequencies.size();
  const auto text = [](std::uint64_t number) { return std::to_string(number); };
  if (after >= before) return text(before) + " draws would become " + text(after);
  double more = static_cast<double>(frequencies.padded);
  for (const merging::MergeableMesh& mesh : set.meshes) {
    more += static_cast<double>(mesh.placed) * (static_cast<double>(mesh.indices) - static_cast<double>(mesh.shaded));
  }
  if (more <= static_cast<double>(before - after) * options.draw_cost) return "";
  return text(before - after) + " draws saved are not worth " + text(static_cast<std::uint64_t>(more)) +
         " more calls of the vertex shader";
}

/// The vertices of all sets of one layout in one buffer, so that what two sets draw lies there once.
void share_vertices(const Scene& scene, std::vector<MergedSet>& sets) {
  std::map<Stamp, std::vector<MergedSet*>> of_layout;
  for (MergedSet& set : sets) {
    of_layout[scene.draws[set.set.meshes[0].draw].levels[0].vertices->layout_stamp()].push_back(&set);
  }
  for (const auto& [layout, alike] : of_layout) {
    std::vector<DrawId> draws;
    for (const MergedSet* set : alike) {
      for (const merging::MergeableMesh& mesh : set->set.meshes) draws.push_back(mesh.draw);
    }
    const merging::SharedVertices shared = merging::shared_vertices(scene, draws);
    auto first = shared.first.begin();
    for (MergedSet* set : alike) {
      set->vertices = shared.vertices;
      const auto end = first + static_cast<std::ptrdiff_t>(set->set.meshes.size());
      set->first_vertex.assign(first, end);
      first = end;
    }
  }
}

}  // namespace

merging::PackedInstances packed_instances(const Scene& scene, const MergedSet& set,
                                          const MergeInstancesOptions& options, const Executor& executor) {
  std::vector<merging::PackedMesh> meshes;
  for (std::size_t m = 0; m < set.set.meshes.size(); ++m) {
    const Draw& draw = scene.draws[set.set.meshes[m].draw];
    const Level& level = draw.levels[0];
    meshes.push_back({draw.name, level.orders[0].indices.view(), set.first_vertex[m], level.vertices->count});
  }
  std::vector<merging::PlacedMesh> placed;
  placed.reserve(set.set.placements.size());
  for (const merging::MergeablePlacement& placement : set.set.placements) {
    placed.push_back({placement.mesh, placement.world});
  }
  merging::PackOptions wanted;
  wanted.cut_well = options.cut_well;
  return merging::pack_instances(meshes, placed, set.groups.instances, set.groups.first, set.frequencies, wanted,
                                 executor);
}

MergedScene merge_instances(const Scene& scene, std::span<const DrawId> draws, const MergeInstancesOptions& options,
                            const Executor& executor) {
  merging::MergeableOptions wanted;
  wanted.materials = options.materials;
  wanted.skinned = options.skinned;
  wanted.poses = options.poses;
  wanted.draw_cost = options.draw_cost;
  merging::MergeableScene found = merging::mergeable_scene(scene, draws, wanted, executor);
  MergedScene result;
  result.left_alone = std::move(found.left_alone);
  for (MergeableSet& set : found.sets) {
    MergedSet merged;
    merged.set = std::move(set);
    if (merged.set.why_not.empty()) {
      merged.groups = groups_of(merged.set, 1, options, executor);
      merged.frequencies = frequencies_of(merged.set, merged.groups.size(), options);
      const std::size_t frequencies = merged.frequencies.frequencies.size();
      if (frequencies > 1) merged.groups = groups_of(merged.set, frequencies, options, executor);
      merged.set.why_not = why_not_worth_it(merged.set, merged.frequencies, merged.groups.size(), options);
    }
    if (!merged.set.why_not.empty()) {
      result.not_merged.push_back(std::move(merged.set));
      continue;
    }
    result.merged.push_back(std::move(merged));
  }
  share_vertices(scene, result.merged);
  for (MergedSet& merged : result.merged) merged.packed = packed_instances(scene, merged, options, executor);
  return result;
}

MergedInstances merged_instances(const Scene& scene, const MergedSet& set) {
  const merging::PackedInstances& packed = set.packed;
  MergedInstances merged;
  merged.material = set.set.material;
  merged.vertices = set.vertices;
  for (std::size_t m = 0; m < set.set.meshes.size(); ++m) {
    merged.meshes.push_back({set.set.meshes[m].draw, set.first_vertex[m]});
  }
  merged.indices = Shared(packed.indices);
  merged.slots = Shared(packed.slots);
  merged.transforms = Shared(packed.transforms);
  merged.draws = packed.draws;
  std::vector<MergedPlace> places;
  std::vector<std::uint32_t> materials;
  for (const std::uint32_t number : packed.placed) {
    const merging::MergeablePlacement& placement = set.set.placements[number];
    places.push_back(placement.place);
    const Draw& draw = scene.draws[set.set.meshes[placement.mesh].draw];
    if (draw.material) materials.push_back(*draw.material);
  }
  merged.places = Shared(std::move(places));
  const auto look = [&](MaterialId id) { return scene.materials[id].look; };
  const bool differ = std::ranges::any_of(
      materials, [&](MaterialId id) { return id != materials[0] && (!look(id) || look(id) != look(materials[0])); });
  if (differ) merged.materials = Shared(std::move(materials));
  for (std::size_t g = 0; g < set.groups.size(); ++g) {
    const std::uint32_t first = packed.first_instance[g];
    const merging::Box& bounds = set.groups.bounds[g];
    merged.groups.push_back({bounds.least, bounds.most, first, packed.first_instance[g + 1] - first});
  }
  return merged;
}

}  // namespace foredraw
