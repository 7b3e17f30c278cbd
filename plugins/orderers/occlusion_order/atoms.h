#pragma once
// Atoms: the pieces of an order that are moved as one, cut where the vertex cache loses least.

#include <foredraw/scene/clusters.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct AtomSize {
  std::uint32_t least = 16;  ///< triangles
  std::uint32_t most = 48;   ///< at least twice the least, or both 1
};

/// Cuts the order of the triangles into atoms. Every vertex that was shaded before a cut and is used behind it, still
/// in the FIFO cache of `cache_size` entries, may have to be shaded twice: the cuts are those with the fewest such
/// vertices, over the whole order. Fewer than twice the least: one atom. O(indices).
Clusters cut_atoms(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::uint32_t cache_size,
                   const AtomSize& size);

/// [i]: how many vertices more atom i shades where something else is drawn before it than where atom i - 1 is. 0 for
/// the first one. O(indices).
std::vector<std::uint32_t> misses_of_cuts(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                          std::uint32_t cache_size, const Clusters& atoms);

}  // namespace foredraw
