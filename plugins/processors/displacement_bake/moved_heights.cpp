#include "moved_heights.h"

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/scene/moves.h>

#include <algorithm>
#include <array>
#include <map>

namespace foredraw::processors::displacement_bake {

namespace {

/// Where a vertex of a tessellated mesh lies, in the numbers of one state of the draw. The weights are of the vertices
/// in rising sequence on an edge, of corners in their own inside of a triangle: corners are never rotated.
struct MeshPlace {
  bool is_inside = false;
  std::array<std::uint32_t, 2> of{};       ///< the edge's vertices, rising; or the triangle
  std::array<std::uint32_t, 2> weights{};  ///< of the first two
  friend auto operator<=>(const MeshPlace&, const MeshPlace&) = default;
};

/// `vertex`, `triangle`: what a number is called.
template <class Vertex, class Triangle>
MeshPlace place_of(const SurfaceSample& sample, std::span<const std::uint32_t> indices, Vertex vertex,
                   Triangle triangle) {
  const auto weights = sample.at.weights();
  const auto third = std::ranges::find(weights, 0u);
  if (third == weights.end()) return {true, {triangle(sample.triangle), 0}, {weights[0], weights[1]}};
  const auto across = static_cast<std::size_t>(third - weights.begin());
  std::size_t a = (across + 1) % 3, b = (across + 2) % 3;
  const auto name = [&](std::size_t corner) { return vertex(indices[3 * std::size_t{sample.triangle} + corner]); };
  if (name(b) < name(a)) std::swap(a, b);
  return {false, {name(a), name(b)}, {weights[a], weights[b]}};
}

}  // namespace

std::optional<DrawHeights> moved(const DrawHeights& heights, const Level& before, const Level& after) {
  const auto vertices = vertex_moves(before, after);
  const auto triangles = triangle_moves(before.stream(), after.stream());
  const auto old_levels = heights.levels.view();
  if (!vertices || !triangles || after.stream().triangle_count() != old_levels.size()) return std::nullopt;
  std::vector<std::uint8_t> levels(old_levels.size());
  for (std::size_t t = 0; t < levels.size(); ++t) levels[(*triangles)[t]] = old_levels[t];

  DrawHeights result = heights;
  result.levels = Shared(std::move(levels));
  const TessellatedMesh was = tessellated_mesh(heights, before), is = tessellated_mesh(result, after);
  const auto old = heights.heights.view();
  std::vector<std::uint16_t> moved(is.vertices(), 0);
  for (std::uint32_t v = 0; v < was.kept; ++v) {
    if ((*vertices)[v] != no_vertex) moved[(*vertices)[v]] = old[v];
  }
  std::vector<std::pair<MeshPlace, std::uint16_t>> places;
  for (std::size_t s = 0; s < was.samples.size(); ++s) {
    const MeshPlace place = place_of(
        was.samples[s], before.stream().indices.view(), [&](std::uint32_t v) { return (*vertices)[v]; },
        [&](std::uint32_t t) { return (*triangles)[t]; });
    places.emplace_back(place, old[was.kept + s]);
  }
  std::ranges::sort(places);
  const auto same = [](std::uint32_t number) { return number; };
  for (std::size_t s = 0; s < is.samples.size(); ++s) {
    const MeshPlace place = place_of(is.samples[s], after.stream().indices.view(), same, same);
    const auto found = std::ranges::lower_bound(places, place, {}, [](const auto& one) { return one.first; });
    if (found == places.end() || found->first != place) return std::nullopt;
    moved[is.kept + s] = found->second;
  }
  result.heights = Shared(std::move(moved));
  return result;
}

}  // namespace foredraw::processors::displacement_bake
