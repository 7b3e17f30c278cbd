#include "content_parts.h"

#include <foredraw/instances/merged_instances.h>

#include <algorithm>

namespace foredraw::bench {

namespace {

template <class T>
std::vector<T> copy_of(const Shared<T>& values) {
  return {values.view().begin(), values.view().end()};
}

}  // namespace

std::vector<PlacedDraw> not_merged(const Scene& scene, std::span<const PlacedDraw> placed) {
  const std::vector<MergedPlace> merged = merged_places(scene);
  std::vector<PlacedDraw> rest;
  for (const PlacedDraw& one : placed) {
    if (!std::ranges::binary_search(merged, one.place)) rest.push_back(one);
  }
  return rest;
}

void add_merged_parts(const Scene& scene, FrameContent& content) {
  for (std::uint32_t set = 0; set < merged_sets(scene).size(); ++set) {
    const MergedInstances& merged = merged_sets(scene)[set];
    FramePart& part = content.parts.emplace_back();
    part.fetch = VertexFetch::merged;
    part.vertices = merged.vertices;
    part.indices = copy_of(merged.indices);
    part.slots = copy_of(merged.slots);
    part.transforms = copy_of(merged.transforms);
    part.materials = copy_of(merged.materials);
    part.merged = merged.draws;
    part.merged_set = set;
    if (part.materials.empty())
      part.material = merged.material.value_or(static_cast<MaterialId>(scene.materials.size()));
    for (const MergedPlace& place : merged.places.view()) part.places.push_back(hash_of(place));
    for (const MergedDraw& draw : merged.draws) {
      const auto slots = merged.slots.view().subspan(draw.first_slot, draw.slot_count);
      for (std::size_t s = 0; s < slots.size(); ++s) {
        if (s > 0 && slots[s].instance == slots[s - 1].instance) continue;
        content.sequence.push_back(merged.places.view()[slots[s].instance]);
      }
    }
  }
}

}  // namespace foredraw::bench
