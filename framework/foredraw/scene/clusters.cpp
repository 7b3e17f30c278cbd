#include <foredraw/scene/clusters.h>

#include <algorithm>

namespace foredraw {

bool is_partition(const Clusters& clusters, std::size_t triangles) {
  const auto& offsets = clusters.offsets;
  if (offsets.empty() || offsets.front() != 0 || offsets.back() != triangles) return false;
  return std::adjacent_find(offsets.begin(), offsets.end(), std::greater_equal<>()) == offsets.end();
}

std::vector<std::uint32_t> in_sequence(const Clusters& clusters, std::span<const std::uint32_t> sequence) {
  std::vector<std::uint32_t> order;
  order.reserve(clusters.offsets.back());
  for (const std::uint32_t c : sequence) {
    for (std::uint32_t t = clusters.offsets[c]; t < clusters.offsets[c + 1]; ++t) order.push_back(t);
  }
  return order;
}

}  // namespace foredraw
