#pragma once
// Tipsify: triangles ordered for the vertex cache, in linear time.
// Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and Reduced Overdraw, SIGGRAPH 2007, "Tipsy strips".

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw {

struct TipsifyOptions {
  int cache_size = 16;  ///< entries of the FIFO cache to order for, at least 3
};

/// The order of the triangles ([new] = old) for a FIFO vertex cache of `cache_size` entries. `indices` holds three a
/// triangle, each below `vertex_count`; any triangles will do, degenerate and non-manifold ones too. Fewer than 2^32
/// indices. O(triangles).
std::vector<std::uint32_t> tipsify(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const TipsifyOptions& options = {});

/// The same into `order` (one entry a triangle), with working memory from `memory`: 44 bytes a triangle and 12 a
/// vertex, besides 4 for each corner of the largest fan.
void tipsify(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const TipsifyOptions& options, std::pmr::memory_resource& memory);

struct Plugin;
Plugin tipsify_plugin();

}  // namespace foredraw
