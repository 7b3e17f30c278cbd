#include "frame_content.h"

#include "content_parts.h"

#include <algorithm>

namespace foredraw::bench {

namespace {

/// Duplicated vertices are counted where they are made.
void count_bytes(const Scene& scene, FrameContent& content) {
  FrameBytes& bytes = content.bytes;
  std::vector<const VertexStreams*> counted;
  for (const FramePart& part : content.parts) {
    if (part.fetch == VertexFetch::in_world) continue;
    // Sets of merged draws may share their vertices.
    if (part.vertices && std::ranges::find(counted, part.vertices.get()) == counted.end()) {
      counted.push_back(part.vertices.get());
      for (const VertexStream& stream : part.vertices->base) bytes.vertices += stream.bytes.size();
    }
    bytes.indices += part.indices.size() * part.index_bytes;
    bytes.transforms += part.transforms.size() * sizeof(MergedTransform);
    if (looks_differ(scene, part.materials)) bytes.transforms += part.materials.size() * sizeof(std::uint32_t);
    bytes.slots += part.slots.size() * sizeof(MergedSlot);
    bytes.commands += part.commands.size() * sizeof(IndexedCommand);
  }
}

}  // namespace

std::string_view to_text(DrawWay way) {
  switch (way) {
    case DrawWay::each: return "each";
    case DrawWay::instanced: return "instanced";
    case DrawWay::group_instanced: return "group-instanced";
    case DrawWay::gpu_instancing: return "gpu-instancing";
    case DrawWay::indirect: return "indirect";
    case DrawWay::indirect_each: return "indirect-each";
    case DrawWay::duplicated: return "duplicated";
    case DrawWay::merged: return "merged";
  }
  return "";
}

std::size_t FrameContent::calls() const {
  std::size_t calls = 0;
  for (const FramePart& part : parts) calls += part.calls();
  return calls;
}

bool looks_differ(const Scene& scene, std::span<const std::uint32_t> materials) {
  const std::vector<std::uint32_t> looks = hashes_of_looks(scene);
  return std::ranges::any_of(materials, [&](std::uint32_t material) { return looks[material] != looks[materials[0]]; });
}

FrameContent frame_content(const Scene& scene, DrawWay way, std::uint64_t most_duplicated) {
  FrameContent content;
  content.way = way;
  std::vector<PlacedDraw> placed = placed_draws(scene);
  if (way == DrawWay::merged || way == DrawWay::duplicated) {
    if (way == DrawWay::merged) {
      add_merged_parts(scene, content);
    } else {
      add_duplicated_parts(scene, placed, most_duplicated, content);
    }
    add_plain_parts(scene, not_merged(scene, placed), DrawWay::instanced, false, content);
  } else {
    add_plain_parts(scene, std::move(placed), way, false, content);
  }
  count_bytes(scene, content);
  return content;
}

FrameContent frame_content_of_each(const Scene& scene, std::span<const MergedPlace> sequence) {
  FrameContent content;
  add_plain_parts(scene, in_sequence(placed_draws(scene), sequence), DrawWay::each, true, content);
  count_bytes(scene, content);
  return content;
}

}  // namespace foredraw::bench
