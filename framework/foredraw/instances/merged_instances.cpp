#include <foredraw/instances/merged_instances.h>

#include <algorithm>

namespace foredraw {

namespace {

std::string named(const char* what, std::size_t number) { return std::string(what) + " " + std::to_string(number); }

std::optional<std::string> mistake_in(const MergedDraw& draw, const MergedInstances& merged) {
  if (draw.frequency == 0 || draw.frequency % 3 != 0) {
    return "has slots of " + std::to_string(draw.frequency) + " entries, which are not whole triangles";
  }
  if (std::uint64_t{draw.frequency} * draw.slot_count > 0xffffffff) return "has more vertices than 32 bits can number";
  if (draw.group >= merged.groups.size()) return "is of group " + std::to_string(draw.group) + ", which does not exist";
  const auto slots = merged.slots.view();
  if (std::uint64_t{draw.first_slot} + draw.slot_count > slots.size()) return "has slots that do not exist";
  const MergedGroup& group = merged.groups[draw.group];
  for (const MergedSlot& slot : slots.subspan(draw.first_slot, draw.slot_count)) {
    if (std::uint64_t{slot.index_offset} + draw.frequency > merged.indices.size()) {
      return "has a slot that reaches past the end of the index buffer";
    }
    if (slot.instance < group.first_instance || slot.instance - group.first_instance >= group.instance_count) {
      return "has a slot of instance " + std::to_string(slot.instance) + ", which is not in its group";
    }
  }
  return std::nullopt;
}

}  // namespace

bool operator==(const MergedInstances& a, const MergedInstances& b) {
  const bool same_vertices =
      a.vertices == b.vertices || (a.vertices && b.vertices && a.vertices->stamp() == b.vertices->stamp());
  return same_vertices && a.material == b.material && a.meshes == b.meshes && a.indices == b.indices &&
         a.slots == b.slots && a.transforms == b.transforms && a.places == b.places && a.materials == b.materials &&
         a.groups == b.groups && a.draws == b.draws;
}

std::span<const MergedInstances> merged_sets(const Scene& scene) {
  const auto* merged = scene.products.find<MergedDraws>();
  return merged == nullptr ? std::span<const MergedInstances>() : merged->sets;
}

std::vector<MergedPlace> merged_places(const Scene& scene) {
  std::vector<MergedPlace> places;
  for (const MergedInstances& merged : merged_sets(scene)) {
    places.insert(places.end(), merged.places.view().begin(), merged.places.view().end());
  }
  std::ranges::sort(places);
  return places;
}

std::optional<std::string> mistake_in(const MergedInstances& merged) {
  if (!merged.vertices || merged.vertices->find("POSITION") == nullptr) return "has no positions";
  for (const VertexStream* stream : merged.vertices->all()) {
    if (stream->count() != merged.vertices->count) {
      return "has " + std::to_string(stream->count()) + " of " + stream->semantic + " for " +
             std::to_string(merged.vertices->count) + " vertices";
    }
  }
  const auto indices = merged.indices.view();
  if (const auto beyond = std::ranges::find_if(indices, [&](std::uint32_t i) { return i >= merged.vertices->count; });
      beyond != indices.end()) {
    return "has index " + std::to_string(*beyond) + ", which is not below its " +
           std::to_string(merged.vertices->count) + " vertices";
  }
  for (const MergedMesh& mesh : merged.meshes) {
    if (mesh.first_vertex >= merged.vertices->count) return "has a mesh that begins after its last vertex";
  }
  const std::size_t instances = merged.transforms.size();
  if (merged.places.size() != instances) {
    return "has " + std::to_string(merged.places.size()) + " places for " + std::to_string(instances) + " transforms";
  }
  if (!merged.materials.empty() && merged.materials.size() != instances) {
    return "has " + std::to_string(merged.materials.size()) + " materials for " + std::to_string(instances) +
           " transforms";
  }
  for (std::size_t g = 0; g < merged.groups.size(); ++g) {
    const MergedGroup& group = merged.groups[g];
    if (std::uint64_t{group.first_instance} + group.instance_count > instances) {
      return named("group", g) + " has instances that do not exist";
    }
  }
  std::uint64_t drawn = 0;
  for (std::size_t d = 0; d < merged.draws.size(); ++d) {
    if (merged.draws[d].first_slot < drawn) return named("draw", d) + " has slots of the one before";
    drawn = std::uint64_t{merged.draws[d].first_slot} + merged.draws[d].slot_count;
    if (auto mistake = mistake_in(merged.draws[d], merged)) return named("draw", d) + " " + *mistake;
  }
  return std::nullopt;
}

}  // namespace foredraw
