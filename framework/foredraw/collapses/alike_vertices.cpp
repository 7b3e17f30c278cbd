#include <foredraw/analysis/equal_vertices.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/alike_vertices.h>
#include <foredraw/scene/stream_meaning.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

std::vector<std::uint32_t> alike_vertices(const JoinedMesh& mesh) {
  std::vector<std::uint32_t> alike;
  alike.reserve(mesh.positions.size());
  for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
    VertexStreams others = *mesh.streams[s];
    std::erase_if(others.base, is_direction);
    for (auto& target : others.morph_targets) std::erase_if(target, is_direction);
    for (const std::uint32_t first : first_of_equals(others)) alike.push_back(mesh.first_vertex[s] + first);
  }
  return alike;
}

std::vector<std::uint32_t> alike_vertices(const AttributeRows& rows, std::span<const glm::vec3> positions) {
  if (rows.directions.empty()) return {};
  std::vector<bool> points(rows.width, false);
  for (const AttributeRows::Direction& one : rows.directions) std::fill_n(points.begin() + one.first, 3, true);
  const std::vector<std::uint32_t> place = welded(positions);
  const auto compared = [&](std::uint32_t a, std::uint32_t b) -> std::weak_ordering {
    if (place[a] != place[b]) return place[a] <=> place[b];
    for (std::size_t i = 0; i < rows.width; ++i) {
      const float one = rows.of(a)[i], other = rows.of(b)[i];
      if (!points[i] && one != other) return one < other ? std::weak_ordering::less : std::weak_ordering::greater;
    }
    return std::weak_ordering::equivalent;
  };
  std::vector<std::uint32_t> sorted(place.size()), alike(place.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::ranges::stable_sort(sorted, [&](std::uint32_t a, std::uint32_t b) { return compared(a, b) < 0; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_known = i > 0 && compared(sorted[i - 1], sorted[i]) == 0;
    alike[sorted[i]] = is_known ? alike[sorted[i - 1]] : sorted[i];
  }
  return alike;
}

}  // namespace foredraw
