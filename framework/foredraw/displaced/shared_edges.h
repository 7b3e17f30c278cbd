#pragma once
// Which edges of triangles are the same one.

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [3t + e] of edge e of triangle t, from corner (e + 1) % 3 to (e + 2) % 3: the first edge 3t' + e' between the same
/// two vertices, in whichever direction; its own number if it is the first. Indices are below `vertices`, and there are
/// fewer than 2^32 of them. O(indices + vertices), but for edges of one vertex, which are sorted.
std::vector<std::uint32_t> first_edges(std::span<const std::uint32_t> indices, std::uint32_t vertices);

/// Where edge 3t + e begins and where it ends.
struct EdgeEnds {
  std::uint32_t from = 0, to = 0;
};
inline EdgeEnds edge_ends(std::span<const std::uint32_t> indices, std::size_t edge) {
  const std::size_t first = edge - edge % 3;
  return {indices[first + (edge + 1) % 3], indices[first + (edge + 2) % 3]};
}

}  // namespace foredraw
