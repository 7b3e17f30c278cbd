#include "slot_order.h"

#include <foredraw/overdraw/outward_sequence.h>

#include <glm/vec3.hpp>

#include <numeric>

namespace foredraw::processors::merge_instances {

namespace {

glm::vec3 in_world(const MergedTransform& transform, const glm::vec3& position) {
  glm::vec3 world;
  for (int row = 0; row < 3; ++row) {
    const float* const from = &transform[static_cast<std::size_t>(4 * row)];
    world[row] = from[0] * position.x + from[1] * position.y + from[2] * position.z + from[3];
  }
  return world;
}

/// What a slot's triangles come to in the world; padding adds nothing.
SurfaceSum surface_of(const MergedInstances& merged, std::span<const glm::vec3> positions, const MergedSlot& slot,
                      std::uint32_t frequency) {
  const MergedTransform& transform = merged.transforms.view()[slot.instance];
  const auto entries = merged.indices.view().subspan(slot.index_offset, frequency);
  SurfaceSum sum;
  for (std::size_t i = 0; i < entries.size(); i += 3) {
    if (entries[i] == entries[i + 1] && entries[i] == entries[i + 2]) continue;
    sum.add(in_world(transform, positions[entries[i]]), in_world(transform, positions[entries[i + 1]]),
            in_world(transform, positions[entries[i + 2]]));
  }
  return sum;
}

/// The vertices that a merged draw fetches, one after the other.
std::shared_ptr<const VertexStreams> fetched(const MergedInstances& merged, std::span<const glm::vec3> positions,
                                             const MergedDraw& draw) {
  std::vector<glm::vec3> world;
  std::vector<std::uint32_t> vertex;
  for (const MergedSlot& slot : merged.slots.view().subspan(draw.first_slot, draw.slot_count)) {
    for (const std::uint32_t index : merged.indices.view().subspan(slot.index_offset, draw.frequency)) {
      world.push_back(in_world(merged.transforms.view()[slot.instance], positions[index]));
      vertex.push_back(index);
    }
  }
  auto streams = std::make_shared<VertexStreams>();
  streams->count = static_cast<std::uint32_t>(vertex.size());
  for (const VertexStream& stream : merged.vertices->base) {
    std::vector<std::byte> bytes;
    if (stream.semantic == "POSITION") {
      const auto plain = std::as_bytes(std::span(world));
      streams->base.push_back({stream.semantic, Format{}, Shared<std::byte>({plain.begin(), plain.end()})});
      continue;
    }
    const std::size_t row = stream.format.bytes;
    for (const std::uint32_t v : vertex) {
      const auto from = stream.bytes.view().subspan(v * row, row);
      bytes.insert(bytes.end(), from.begin(), from.end());
    }
    streams->base.push_back({stream.semantic, stream.format, Shared<std::byte>(std::move(bytes))});
  }
  return streams;
}

}  // namespace

Scene group_scene(const Scene& scene, const MergedInstances& merged, std::uint32_t group) {
  Scene result;
  result.name = scene.name;
  result.materials = scene.materials;
  result.images = scene.images;
  const std::vector<glm::vec3> positions = decode_vec3(*merged.vertices->find("POSITION"));
  for (const MergedDraw& draw : merged.draws) {
    if (draw.group != group) continue;
    std::vector<std::uint32_t> indices(std::size_t{draw.slot_count} * draw.frequency);
    std::iota(indices.begin(), indices.end(), 0u);
    Level level;
    level.vertices = fetched(merged, positions, draw);
    level.orders.push_back({Shared<std::uint32_t>(std::move(indices))});
    Draw own;
    own.name = scene.name;
    own.levels.push_back(std::move(level));
    own.material = merged.material;
    own.traits = {traits::triangles};
    result.draws.push_back(std::move(own));
  }
  return result;
}

std::vector<MergedSlot> outward_slots(const MergedInstances& merged, const Executor& executor) {
  const auto slots = merged.slots.view();
  const std::vector<glm::vec3> positions = decode_vec3(*merged.vertices->find("POSITION"));
  std::vector<MergedSlot> sorted(slots.begin(), slots.end());
  std::vector<std::vector<const MergedDraw*>> groups(merged.groups.size());
  for (const MergedDraw& draw : merged.draws) groups[draw.group].push_back(&draw);
  executor.for_each(groups.size(), [&](std::size_t g) {
    std::vector<std::vector<SurfaceSum>> parts;
    SurfaceSum whole;
    for (const MergedDraw* draw : groups[g]) {
      std::vector<SurfaceSum>& own = parts.emplace_back();
      for (const MergedSlot& slot : slots.subspan(draw->first_slot, draw->slot_count)) {
        own.push_back(surface_of(merged, positions, slot, draw->frequency));
        whole += own.back();
      }
    }
    for (std::size_t d = 0; d < groups[g].size(); ++d) {
      const std::vector<std::uint32_t> sequence = outward_sequence(parts[d], whole);
      const std::uint32_t first = groups[g][d]->first_slot;
      for (std::size_t s = 0; s < sequence.size(); ++s) sorted[first + s] = slots[first + sequence[s]];
    }
  });
  return sorted;
}

}  // namespace foredraw::processors::merge_instances
