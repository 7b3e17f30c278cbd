#pragma once
// Tipsify: triangles ordered for the vertex cache, in linear time.
// Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and Reduced Overdraw, SIGGRAPH 2007, "Tipsy
// strips".

#include <cstdint>
#include <functional>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

struct TipsifyOptions {
  int cache_size = 16;           ///< entries of the FIFO vertex cache to order for, at least 3
  std::optional<int> built_for;  ///< entries of the cache that fans are chosen for, at least 3; none: cache_size
};

/// Whether the sizes can be had: vertices are numbered in 31 bits, and every index and every miss in 32.
constexpr bool tipsify_takes(std::uint64_t index_count, std::uint64_t vertex_count,
                             const TipsifyOptions& options = {}) {
  const auto cache_size = static_cast<std::uint64_t>(options.built_for.value_or(options.cache_size));
  return vertex_count < std::uint64_t{1} << 31 && index_count + cache_size + 3 < std::uint64_t{1} << 32;
}

/// The order of the triangles ([new] = old) for a FIFO vertex cache of `cache_size` entries. `indices` holds three a
/// triangle, each below `vertex_count`; any triangles will do, degenerate and non-manifold ones too. O(triangles).
/// Where tipsify_takes() does not hold the order stays as it is.
std::vector<std::uint32_t> tipsify(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const TipsifyOptions& options = {});

/// The same into `order` (one entry a triangle), with working memory from `memory`: 48 bytes a triangle and 8 a vertex
/// (16 where a vertex has more than 255 corners, or the draw more than 5.5 million triangles), and besides 12 for each
/// corner of the largest fan and 8 for each dead end from which the way led back, which are few.
void tipsify(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const TipsifyOptions& options, std::pmr::memory_resource& memory);

/// The new index buffer itself: the indices in the order that tipsify() answers with, corners not rotated. Faster than
/// applying the order, as the indices are at hand when a triangle's turn comes.
std::vector<std::uint32_t> tipsify_indices(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                           const TipsifyOptions& options = {});

/// The same into `ordered` (as long as `indices`, and apart from it), with 24 bytes a triangle less of working memory.
void tipsify_indices(std::span<std::uint32_t> ordered, std::span<const std::uint32_t> indices, std::size_t vertex_count,
                     const TipsifyOptions& options, std::pmr::memory_resource& memory);

/// Calls a task once for each number below a count, in any order, from any threads.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// tipsify() for each of `parts` parts on its own, one after the other in the order that comes out. The draw is cut by
/// where its triangles lie, into parts of about equal size, of which there are fewer where they would have less than
/// 10000 triangles. The answer depends on `parts`, never on `for_each`. `positions` holds x, y and z of every vertex;
/// what is not finite counts as 0. Every part that is worked on holds 16 bytes a triangle and 4 for each vertex of the
/// draw, besides tipsify's own memory.
std::vector<std::uint32_t> tipsify_parts(std::span<const std::uint32_t> indices, std::span<const float> positions,
                                         int parts, const TipsifyOptions& options, const ForEach& for_each);

/// The new index buffer itself, as with tipsify_indices().
std::vector<std::uint32_t> tipsify_parts_indices(std::span<const std::uint32_t> indices,
                                                 std::span<const float> positions, int parts,
                                                 const TipsifyOptions& options, const ForEach& for_each);

struct Plugin;
Plugin tipsify_plugin();

}  // namespace foredraw
