#pragma once
// What frames are put together of.

#include "frame_content.h"

namespace foredraw::bench {

/// Appends parts that draw `placed` with vertex and index buffers: one part for each vertex layout.
/// is_ordered: in the sequence of `placed`, else sorted so that state changes least.
void add_plain_parts(const Scene& scene, std::vector<PlacedDraw> placed, DrawWay way, bool is_ordered,
                     FrameContent& content);

/// Of `placed` (sorted by place), what Scene::merged does not show.
std::vector<PlacedDraw> not_merged(const Scene& scene, std::span<const PlacedDraw> placed);

void add_merged_parts(const Scene& scene, FrameContent& content);

/// And counts the bytes of their vertices and indices. `placed`: sorted by place.
void add_duplicated_parts(const Scene& scene, std::span<const PlacedDraw> placed, std::uint64_t most_bytes,
                          FrameContent& content);

/// Whether instances look different, so that each has to say its material.
bool looks_differ(const Scene& scene, std::span<const std::uint32_t> materials);

}  // namespace foredraw::bench
