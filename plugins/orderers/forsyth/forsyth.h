#pragma once
// Forsyth's order: the best-scoring triangle near the cache is drawn next, whatever the size of the real cache.
// Tom Forsyth: Linear-Speed Vertex Cache Optimisation, 2006.

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw {

struct ForsythOptions {
  int cache_size = 32;  ///< entries of the LRU cache that the scores are made from, 3 to 64
};

/// The order of the triangles ([new] = old), good for caches of any kind up to about `cache_size` entries. `indices`
/// holds three a triangle, each below `vertex_count`; any triangles will do, degenerate and non-manifold ones too.
/// O(triangles * cache_size), whatever the valences.
std::vector<std::uint32_t> forsyth(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const ForsythOptions& options = {});

/// The same into `order` (one entry a triangle), with working memory from `memory`: 25 bytes a triangle and 12 a
/// vertex.
void forsyth(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const ForsythOptions& options, std::pmr::memory_resource& memory);

struct Plugin;
Plugin forsyth_plugin();

}  // namespace foredraw
