#pragma once
#include <foredraw/scene/vertex_streams.h>

#include <span>

namespace foredraw {

/// Streams whose vertex v is the vertex from[v] of these, in every attribute and morph target. Each number is below the
/// number of vertices; a vertex may be taken several times, or not at all.
VertexStreams taken_vertices(const VertexStreams& streams, std::span<const std::uint32_t> from);

}  // namespace foredraw
