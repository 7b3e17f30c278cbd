#include <foredraw/analysis/closed_surfaces.h>

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/joined_sets.h>

#include <algorithm>
#include <utility>

namespace foredraw {

std::vector<bool> closed_outwards(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  const std::size_t triangles = indices.size() / 3;
  for (const glm::vec3& p : positions) {  // what is not finite has no order
    if (!is_finite(p)) return std::vector<bool>(triangles, false);
  }
  const std::vector<std::uint32_t> at = welded(positions);
  JoinedSets components(positions.size());
  struct Edge {
    std::uint32_t low, high;
    std::int32_t way;  // 1 from low to high
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < 3 * triangles; i += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = at[indices[i + c]], to = at[indices[i + (c + 1) % 3]];
      components.join(from, to);
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair(e.low, e.high); });
  std::vector<bool> is_open(positions.size(), false);  // [component]
  for (std::size_t i = 0; i < edges.size();) {
    std::int32_t sum = 0;
    const std::size_t begin = i;
    for (; i < edges.size() && edges[i].low == edges[begin].low && edges[i].high == edges[begin].high; ++i) {
      sum += edges[i].way;
    }
    if (sum != 0) is_open[components.of(edges[begin].low)] = true;
  }
  // From one of its own vertices, so that a component far from the origin loses nothing.
  std::vector<double> volume(positions.size(), 0);
  for (std::size_t i = 0; i < 3 * triangles; i += 3) {
    const std::uint32_t component = components.of(at[indices[i]]);
    const glm::dvec3 origin(positions[component]);
    const glm::dvec3 a = glm::dvec3(positions[indices[i]]) - origin;
    const glm::dvec3 b = glm::dvec3(positions[indices[i + 1]]) - origin;
    const glm::dvec3 c = glm::dvec3(positions[indices[i + 2]]) - origin;
    volume[component] += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  std::vector<bool> result;
  for (std::size_t i = 0; i < 3 * triangles; i += 3) {
    const std::uint32_t component = components.of(at[indices[i]]);
    result.push_back(!is_open[component] && volume[component] > 0);
  }
  return result;
}

}  // namespace foredraw
