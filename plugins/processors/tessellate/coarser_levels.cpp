#include "coarser_levels.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace foredraw {

std::vector<TessellationLevels> halved(std::span<const TessellationLevels> levels) {
  const auto half = [](float level) { return std::max(level / 2, 1.0f); };
  std::vector<TessellationLevels> result;
  result.reserve(levels.size());
  for (const TessellationLevels& of : levels)
    result.push_back({{half(of.outer[0]), half(of.outer[1]), half(of.outer[2])}, half(of.inner)});
  return result;
}

std::optional<std::vector<std::uint32_t>> by_vertices_of(const TessellatedMesh& fine, const TessellatedMesh& coarse) {
  const auto place = [](const SurfaceSample& sample) { return std::tuple(sample.triangle, sample.at.u, sample.at.v); };
  std::vector<std::uint32_t> order(fine.samples.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto of_fine = [&](std::uint32_t s) { return place(fine.samples[s]); };
  std::ranges::stable_sort(order, {}, of_fine);
  std::vector<std::uint32_t> vertices(coarse.samples.size());  // [sample] of the fine mesh
  for (std::size_t s = 0; s < vertices.size(); ++s) {
    const auto at = std::ranges::lower_bound(order, place(coarse.samples[s]), {}, of_fine);
    if (at == order.end() || of_fine(*at) != place(coarse.samples[s])) return std::nullopt;
    vertices[s] = fine.kept + *at;
  }
  std::vector<std::uint32_t> indices = coarse.indices;
  for (std::uint32_t& v : indices) v = v < coarse.kept ? v : vertices[v - coarse.kept];
  return indices;
}

}  // namespace foredraw
