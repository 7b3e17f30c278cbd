#include "weld.h"

#include <foredraw/analysis/vertex_rows.h>
#include <foredraw/scene/draw.h>

#include <algorithm>
#include <bit>

namespace foredraw {

namespace {

/// Finds the first vertex of equal content. Open addressing, at most half full.
class FirstOfEquals {
 public:
  explicit FirstOfEquals(const VertexRows& rows) : rows_(rows), slots_(std::bit_ceil(2 * rows.size() + 1), no_vertex) {}

  /// The first vertex with v's content that was asked for; v itself where there was none.
  std::uint32_t of(std::uint32_t v) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = content_hash(rows_[v]).low & mask;; at = (at + 1) & mask) {
      if (slots_[at] == no_vertex) return slots_[at] = v;
      if (std::ranges::equal(rows_[slots_[at]], rows_[v])) return slots_[at];
    }
  }

 private:
  const VertexRows& rows_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

Weld weld(const VertexStreams& vertices, std::span<const std::span<const std::uint32_t>> index_streams,
          const WeldOptions& options) {
  std::vector<bool> used(vertices.count, options.keep_unused);
  for (const auto& indices : index_streams) {
    for (std::uint32_t v : indices) used[v] = true;
  }

  const VertexRows rows(vertices);
  FirstOfEquals first(rows);
  Weld result;
  result.destination.assign(vertices.count, no_vertex);
  for (std::uint32_t v = 0; v < vertices.count; ++v) {
    if (!used[v]) {
      ++result.unused;
      continue;
    }
    const std::uint32_t original = first.of(v);
    if (original == v) {
      result.destination[v] = result.count++;
    } else {
      result.destination[v] = result.destination[original];
      ++result.merged;
    }
  }
  return result;
}

}  // namespace foredraw
