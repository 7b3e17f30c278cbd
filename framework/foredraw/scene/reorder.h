#pragma once
// Orders applied. Whatever belongs to triangles or vertices moves with them; nothing else changes.

#include <foredraw/scene/draw.h>

#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// order[new] = old triangle. A permutation of all triangles.
using IndexOrder = std::vector<std::uint32_t>;
/// order[new] = old vertex. A permutation of all vertices.
using VertexOrder = std::vector<std::uint32_t>;

bool is_permutation(std::span<const std::uint32_t> order, std::size_t count);

/// The order that makes the triangles `to` of the triangles `from`; corners may be turned, and equal triangles keep
/// their sequence. Nothing where these are not the same triangles. O(n log n).
std::optional<IndexOrder> order_between(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to);

/// The index stream in the new order; corners are not rotated. Clusters stay where each is still contiguous in it, in
/// their new sequence, and are lost where one is torn.
IndexStream with_triangle_order(const IndexStream& stream, std::span<const std::uint32_t> order);

/// The draw with orders[0] of full detail put in the new order.
Draw with_triangle_order(const Draw& draw, std::span<const std::uint32_t> order);

/// The streams with vertex v at destination[v]; several may share one (their bytes must then be equal), and no_vertex
/// leaves one out. `count` is the number of vertices afterwards.
VertexStreams with_vertices_moved(const VertexStreams& streams, std::span<const std::uint32_t> destination,
                                  std::uint32_t count);

/// The draw drawing from `moved`, which came from its own vertices by `destination`: indices renumbered in every order
/// of the level `level` alone.
Draw with_vertices_moved(const Draw& draw, std::size_t level, std::shared_ptr<const VertexStreams> moved,
                         std::span<const std::uint32_t> destination);

}  // namespace foredraw
