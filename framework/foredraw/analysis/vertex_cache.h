#pragma once
// Models of the caches that a vertex passes on its way through the GPU: the post-transform cache, which saves shading a
// vertex twice, and the memory cache in front of the vertex buffer. Indices are of triangle lists, and below
// `vertex_count`.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw {

/// A first-in-first-out cache of vertex numbers. A vertex that hits stays where it is in the queue. O(1) each call.
/// Fewer than 2^31 vertices may enter between two flushes.
class FifoCache {
 public:
  /// `size` entries, at least 1; more than 2^30 are as good as 2^30.
  FifoCache(std::size_t vertex_count, std::uint32_t size)
      : entered_(vertex_count, 0), size_(std::min(size, std::uint32_t{1} << 30)), now_(size_ + 1) {}

  bool holds(std::uint32_t vertex) const { return now_ - entered_[vertex] <= size_; }

  /// Draws the vertex: true where it missed and so was shaded and entered.
  bool misses(std::uint32_t vertex) { return misses({&vertex, 1}) != 0; }

  /// Draws vertices one after the other: how many missed.
  std::uint32_t misses(std::span<const std::uint32_t> vertices) {
    const std::uint32_t before = now_;
    std::uint32_t now = now_;  // a register, where the member would be written each time
    for (const std::uint32_t vertex : vertices) {
      const bool missed = now - entered_[vertex] > size_;
      entered_[vertex] = missed ? now : entered_[vertex];  // no branch: hits and misses have no pattern
      now += missed;
    }
    now_ = now;
    return now - before;
  }

  /// Empties the cache.
  void flush() {
    now_ += size_ + 1;
    if (now_ < std::uint32_t{1} << 31) return;
    std::ranges::fill(entered_, 0);
    now_ = size_ + 1;
  }

 private:
  // The clock counts the vertices that entered; who entered at most `size` ticks ago is still inside.
  std::vector<std::uint32_t> entered_;
  std::uint32_t size_;
  std::uint32_t now_;
};

struct CacheCount {
  std::uint64_t misses = 0;  ///< vertices shaded
  std::uint64_t triangles = 0;
  std::uint64_t referenced = 0;  ///< different vertices
  friend bool operator==(const CacheCount&, const CacheCount&) = default;
};

/// Misses of a FIFO cache of `size` entries. O(indices + vertices).
CacheCount count_fifo(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::uint32_t size);

/// Misses of a cache of `size` entries that drops the vertex least recently drawn. O(indices + vertices) for any size.
CacheCount count_lru(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::uint32_t size);

/// GPUs that shade vertices in batches (Kerbl et al., "Revisiting the Vertex Cache", HPG 2018): a FIFO that starts
/// empty again whenever the next triangle does not fit.
struct BatchModel {
  std::string_view name;
  std::uint32_t cache_size;       ///< entries
  std::uint32_t warp_size;        ///< vertices shaded together; 0: any number
  std::uint32_t primitive_group;  ///< triangles in a batch; 0: any number
};

/// The three that meshoptimizer's statistics use.
inline constexpr std::array<BatchModel, 3> batch_models = {
    {{"nvidia", 32, 32, 32}, {"amd", 14, 64, 128}, {"intel", 128, 0, 0}}};

/// A batch ends before a triangle that would exceed its triangles, or its vertices by the triangle's corners that the
/// cache does not hold. The figures are those of meshoptimizer's meshopt_analyzeVertexCache.
inline std::uint64_t batch_misses(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                  const BatchModel& model) {
  FifoCache cache(vertex_count, model.cache_size);
  std::uint64_t misses = 0, vertices_in_batch = 0, triangles_in_batch = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const auto corners = indices.subspan(i, 3);
    // Before the triangle is drawn: a corner named twice counts twice.
    const auto absent = static_cast<std::uint64_t>(
        std::count_if(corners.begin(), corners.end(), [&](std::uint32_t vertex) { return !cache.holds(vertex); }));
    if ((model.primitive_group > 0 && triangles_in_batch == model.primitive_group) ||
        (model.warp_size > 0 && vertices_in_batch + absent > model.warp_size)) {
      cache.flush();
      vertices_in_batch = 0;
      triangles_in_batch = 0;
    }
    const std::uint32_t missed = cache.misses(corners);
    misses += missed;
    vertices_in_batch += missed;
    ++triangles_in_batch;
  }
  return misses;
}

/// The same, and what it is measured against.
CacheCount count_batches(std::span<const std::uint32_t> indices, std::size_t vertex_count, const BatchModel& model);

struct FetchCount {
  std::uint64_t fetched = 0;     ///< bytes read from memory, whole lines
  std::uint64_t referenced = 0;  ///< bytes of the different vertices drawn
  friend bool operator==(const FetchCount&, const FetchCount&) = default;
};

/// Vertices of `vertex_size` bytes one behind the other, read in the order of the indices through a direct-mapped cache
/// of 128 KiB in lines of 64 bytes. The figures are those of meshoptimizer's meshopt_analyzeVertexFetch.
FetchCount count_fetches(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::size_t vertex_size);

}  // namespace foredraw
