#pragma once
// Lookahead: triangles ordered for the vertex cache in fans, as tipsify does, where each fan is chosen by drawing the
// ones that might follow it, on trial. Source: own; after Sander, Nehab, Barczak 2007 (tipsy strips).

#include <foredraw/analysis/vertex_cache.h>

#include <atomic>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw {

/// The cache that an order is made for.
enum class LookaheadTarget {
  robust,  ///< a FIFO of `cache_size`, and no worse than tipsify for smaller and larger ones, LRU and batches
  fifo,    ///< a FIFO of `cache_size`, whatever others do
  nvidia,  ///< the batch models of analysis/vertex_cache.h
  amd,
  intel,
};

/// How much is tried out. `high` walks twice, with deeper trials and as `balanced` does, and keeps the order that
/// misses less in the cache that it is made for: it is never worse than `balanced` there.
enum class LookaheadQuality { fast, balanced, high };

struct LookaheadOptions {
  LookaheadQuality quality = LookaheadQuality::balanced;  ///< sets the next two where they are 0
  int candidates = 0;                                     ///< centres of the next fan that are tried, 0 to 64
  int depth = 0;                                          ///< fans drawn on trial behind each, 0 to 64
  LookaheadTarget target = LookaheadTarget::robust;
  int cache_size = 16;                        ///< entries of the FIFO cache, 3 to 256; the batch models have their own
  const std::atomic<bool>* cancel = nullptr;  ///< looked at between fans; once it is set, the order stays as it is
};

/// Whether the size can be had. What enters the cache is counted in 32 bits: every index may, and a batch of
/// NVIDIA-like GPUs, which ends with 30 vertices or more, is followed by 32 entries of nothing.
constexpr bool lookahead_takes(std::uint64_t index_count) { return index_count <= 2'000'000'000; }

/// The cache that these options order for; without batches it is a plain FIFO.
BatchModel cache_of(const LookaheadOptions& options);

/// The order of the triangles ([new] = old) for a vertex cache. `indices` holds three a triangle, each below
/// `vertex_count`; any triangles will do, degenerate and non-manifold ones too. Where lookahead_takes() does not hold
/// the order stays as it is. O(triangles * (candidates + depth) * cache size), whatever the valences.
std::vector<std::uint32_t> lookahead(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                     const LookaheadOptions& options = {});

/// The same into `order` (one entry a triangle), with working memory from `memory`: at most 64 bytes a triangle, and 16
/// a vertex where there are more than triangles.
void lookahead(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
               const LookaheadOptions& options, std::pmr::memory_resource& memory);

struct Plugin;
Plugin lookahead_plugin();

}  // namespace foredraw
