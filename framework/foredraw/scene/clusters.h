#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Contiguous ranges of the triangle order: cluster c holds the triangles offsets[c] to offsets[c + 1] - 1. The first
/// offset is 0, the last is the number of triangles, and none is empty.
struct Clusters {
  std::vector<std::uint32_t> offsets;

  std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  friend bool operator==(const Clusters&, const Clusters&) = default;
};

/// Whether the offsets are a partition of `triangles` triangles as described above.
bool is_partition(const Clusters& clusters, std::size_t triangles);

/// The order of the triangles, [new] = old, in which the clusters are drawn in this sequence, [new] = old.
std::vector<std::uint32_t> in_sequence(const Clusters& clusters, std::span<const std::uint32_t> sequence);

}  // namespace foredraw
