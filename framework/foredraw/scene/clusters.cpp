#include <foredraw/scene/clusters.h>

#include <algorithm>

namespace foredraw {

bool is_partition(const Clusters& clusters, std::size_t triangles) {
  const auto& offsets = clusters.offsets;
  if (offsets.empty() || offsets.front() != 0 || offsets.back() != triangles) return false;
  return std::adjacent_find(offsets.begin(), offsets.end(), std::greater_equal<>()) == offsets.end();
}

}  // namespace foredraw
