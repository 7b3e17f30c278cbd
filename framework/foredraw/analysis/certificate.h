#pragma once
// The proof that a reorder changed nothing but order: computed from what the GPU would be given, not from the order.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/draw.h>

namespace foredraw {

/// What one order of a level draws, whatever the sequence of triangles and the numbering of vertices: for each triangle
/// the content of its three vertices (every base stream and morph target, with name and format) in its own corner
/// order, summed over the triangles. Two draws with equal certificates draw the same triangles with the same vertex
/// data.
struct Certificate {
  std::uint64_t triangles = 0;
  Stamp sum;
  friend bool operator==(const Certificate&, const Certificate&) = default;
};

/// Every index must be below the number of vertices. Indices that make no whole triangle are left out.
Certificate certificate_of(const VertexStreams& vertices, std::span<const std::uint32_t> indices, Analyses& analyses);

/// Of every order of every level in turn.
std::vector<Certificate> certificates_of(const Draw& draw, Analyses& analyses);

}  // namespace foredraw
