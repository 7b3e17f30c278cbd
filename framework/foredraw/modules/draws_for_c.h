#pragma once
// Vertices and clusters as callers see them, in memory of ours.

#include <foredraw/c/draw.h>
#include <foredraw/scene/draw.h>

#include <vector>

namespace foredraw {

/// All base streams but positions. They refer to `vertices`.
std::vector<foredraw_stream> streams_for_c(const VertexStreams& vertices);

/// A draw without name, of triangles; `positions` holds three floats for each vertex.
foredraw_draw draw_for_c(const VertexStreams& vertices, std::span<const std::uint32_t> indices, const float* positions,
                         const std::vector<foredraw_stream>& streams, const Clusters* clusters);

}  // namespace foredraw
