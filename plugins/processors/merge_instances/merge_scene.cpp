#include "merge_scene.h"

#include "packing.h"
#include "shared_vertices.h"

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

using processors::merge_instances::MergeableSet;
using processors::merge_instances::PackedMesh;
using processors::merge_instances::PlacedMesh;

/// `first_vertex`: [mesh]; empty where no buffer is chosen yet.
std::vector<PackedMesh> meshes_of(const Scene& scene, const MergeableSet& set,
                                  std::span<const std::uint32_t> first_vertex) {
  std::vector<PackedMesh> meshes;
  for (std::size_t m = 0; m < set.meshes.size(); ++m) {
    const Draw& draw = scene.draws[set.meshes[m].draw];
    const Level& level = draw.levels[0];
    meshes.push_back(
        {draw.name, level.orders[0].indices.view(), first_vertex.empty() ? 0 : first_vertex[m], level.vertices->count});
  }
  return meshes;
}

std::vector<PlacedMesh> placed_of(const MergeableSet& set) {
  std::vector<PlacedMesh> placed;
  placed.reserve(set.placements.size());
  for (const processors::merge_instances::MergeablePlacement& placement : set.placements) {
    placed.push_back({placement.mesh, placement.world, placement.box});
  }
  return placed;
}

/// Of the nodes: one that draws a mesh many times takes one draw for it.
std::uint64_t plain_draws(const MergeableSet& set) {
  std::vector<std::pair<NodeId, std::uint32_t>> drawn;
  drawn.reserve(set.placements.size());
  for (const processors::merge_instances::MergeablePlacement& placement : set.placements) {
    drawn.push_back({placement.place.node, placement.place.primitive});
  }
  std::ranges::sort(drawn);
  return static_cast<std::uint64_t>(std::unique(drawn.begin(), drawn.end()) - drawn.begin());
}

/// What is known only when slots and groups are: whether the draws that are saved are worth what the shader does more.
std::string why_not_worth_it(const MergeableSet& set, const processors::merge_instances::SlotLayout& layout,
                             const MergeInstancesOptions& options) {
  const std::uint64_t before = plain_draws(set);
  const std::uint64_t after = layout.draws();
  const auto text = [](std::uint64_t number) { return std::to_string(number); };
  if (after >= before) return text(before) + " draws would become " + text(after);
  double more = static_cast<double>(layout.frequencies.padded);
  for (const processors::merge_instances::MergeableMesh& mesh : set.meshes) {
    more += static_cast<double>(mesh.placed) * (static_cast<double>(mesh.indices) - static_cast<double>(mesh.shaded));
  }
  if (more <= static_cast<double>(before - after) * options.draw_cost) return "";
  return text(before - after) + " fewer draws are not worth " + text(static_cast<std::uint64_t>(more)) +
         " more vertex shader calls";
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
      for (const processors::merge_instances::MergeableMesh& mesh : set->set.meshes) draws.push_back(mesh.draw);
    }
    const processors::merge_instances::SharedVertices shared =
        processors::merge_instances::shared_vertices(scene, draws);
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

processors::merge_instances::PackedInstances packed_instances(const Scene& scene, const MergedSet& set,
                                                              const MergeInstancesOptions& options,
                                                              const Executor& executor) {
  return processors::merge_instances::pack_instances(meshes_of(scene, set.set, set.first_vertex), placed_of(set.set),
                                                     set.layout.groups, set.layout.frequencies, {options.cut_well},
                                                     executor);
}

MergedScene merge_scene(const Scene& scene, std::span<const DrawId> draws, const MergeSceneOptions& options,
                        const Executor& executor) {
  processors::merge_instances::MergeableOptions wanted;
  wanted.materials = options.materials;
  wanted.skinned = options.skinned;
  wanted.poses = options.poses;
  wanted.draw_cost = options.draw_cost;
  processors::merge_instances::MergeableScene found =
      processors::merge_instances::mergeable_scene(scene, draws, wanted, executor);
  MergedScene result;
  result.left_alone = std::move(found.left_alone);
  for (MergeableSet& set : found.sets) {
    processors::merge_instances::SlotLayout layout;
    if (set.why_not.empty()) {
      layout = processors::merge_instances::slot_layout(meshes_of(scene, set, {}), placed_of(set), options, executor);
      set.why_not = why_not_worth_it(set, layout, options);
    }
    if (!set.why_not.empty()) {
      result.not_merged.push_back(std::move(set));
      continue;
    }
    MergedSet& merged = result.merged.emplace_back();
    merged.set = std::move(set);
    merged.layout = std::move(layout);
  }
  share_vertices(scene, result.merged);
  for (MergedSet& merged : result.merged) merged.packed = packed_instances(scene, merged, options, executor);
  return result;
}

MergedInstances merged_instances(const Scene& scene, const MergedSet& set) {
  const processors::merge_instances::PackedInstances& packed = set.packed;
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
    const processors::merge_instances::MergeablePlacement& placement = set.set.placements[number];
    places.push_back(placement.place);
    const Draw& draw = scene.draws[set.set.meshes[placement.mesh].draw];
    if (draw.material) materials.push_back(*draw.material);
  }
  merged.places = Shared(std::move(places));
  const auto look = [&](MaterialId id) { return scene.materials[id].look; };
  const bool differ = std::ranges::any_of(
      materials, [&](MaterialId id) { return id != materials[0] && (!look(id) || look(id) != look(materials[0])); });
  if (differ) merged.materials = Shared(std::move(materials));
  merged.groups = packed.groups;
  return merged;
}

}  // namespace foredraw
