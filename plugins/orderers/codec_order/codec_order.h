#pragma once
// Triangles in an order in which compressed files are short: for the triangle codec of meshopt compression, and for
// vertex codecs that keep differences of neighbours.
//
// The codec remembers 16 edges and 16 vertices. It says in one byte a triangle at one of these edges whose third corner
// is new, remembered, or the neighbour by number of the last one that it had to name. F. Giesen: Simple lossless index
// buffer compression, 2013; C. Stokes: Vertex cache optimised index buffer compression, 2014. The walk is ours.

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// The order of the triangles ([new] = old): a walk from triangle to triangle over the 15 edges passed last. At each
/// step a triangle between vertices that are known comes before one that brings a new vertex, and of several the one at
/// the edge passed last. So rows of triangles grow along the row before: each third corner that is old has the number
/// beside that of the one before, once vertices are numbered by first use. Three indices a triangle, each below
/// `vertex_count`. O(indices), for meshes whose vertices have few triangles.
std::vector<std::uint32_t> codec_order(std::span<const std::uint32_t> indices, std::size_t vertex_count);

struct Plugin;
Plugin codec_order_plugin();

}  // namespace foredraw
