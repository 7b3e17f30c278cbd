#include "fewest_inner_edges.h"

#include <glm/geometric.hpp>

#include <limits>
#include <utility>

namespace foredraw::processors::particle_trim {

std::vector<std::array<std::uint32_t, 3>> fewest_inner_edges(std::span<const glm::dvec2> corners) {
  const std::size_t count = corners.size();
  if (count < 3) return {};
  // [first * count + last]: of the part of the polygon on one side of the edge between them, that edge included.
  std::vector<double> length(count * count, 0);
  std::vector<std::size_t> apex(count * count, 0);
  for (std::size_t width = 2; width < count; ++width) {
    for (std::size_t first = 0; first + width < count; ++first) {
      const std::size_t last = first + width;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = first + 1; k < last; ++k) {
        const double both = length[first * count + k] + length[k * count + last];
        if (both >= least) continue;
        least = both;
        apex[first * count + last] = k;
      }
      const bool is_outer = first == 0 && last + 1 == count;
      length[first * count + last] = least + (is_outer ? 0 : glm::distance(corners[first], corners[last]));
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> parts{{0, count - 1}};
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    if (last < first + 2) continue;
    const std::size_t k = apex[first * count + last];
    triangles.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(last)});
    parts.emplace_back(k, last);
    parts.emplace_back(first, k);
  }
  return triangles;
}

}  // namespace foredraw::processors::particle_trim
