#include <foredraw/displaced/seam_table.h>

#include <algorithm>
#include <bit>

namespace foredraw {

namespace {

std::uint16_t mean_height(std::span<const glm::ivec2> places, const foredraw_height_map& map) {
  std::uint64_t sum = 0;
  for (const glm::ivec2 place : places) sum += foredraw_height_sum(&map, place.x, place.y);
  return static_cast<std::uint16_t>(sum / places.size() >> 16);
}

}  // namespace

SeamTable seam_table(const SeamEdges& seams, const foredraw_height_map& map, std::size_t meshes) {
  const std::vector<std::uint32_t> factors = seam_factors(seams, {map.width, map.height});
  const SeamPoints points = seam_points(seams, factors, map);
  SeamTable table;
  table.sides.resize(meshes);
  std::size_t next_point = seams.corners.size();
  for (std::size_t e = 0; e < seams.edges.size(); ++e) {
    const SharedEdge& edge = seams.edges[e];
    if (edge.kind != EdgeKind::seam) continue;
    const auto number = static_cast<std::uint32_t>(table.firsts.size());
    table.firsts.push_back(static_cast<std::uint32_t>(table.heights.size()));
    table.parts_log2.push_back(static_cast<std::uint8_t>(std::countr_zero(factors[e])));
    for (std::uint32_t step = 1; step < factors[e]; ++step) {
      table.heights.push_back(mean_height(points.places_of(points.points[next_point++]), map));
    }
    for (const EdgeSide& side : seams.sides_of(edge)) {
      table.sides[side.mesh].push_back({3 * side.triangle + side.corner, 2 * number + (side.is_reversed ? 1u : 0u)});
    }
  }
  for (auto& of_mesh : table.sides) std::ranges::sort(of_mesh, {}, &foredraw_seam_side::side);
  return table;
}

}  // namespace foredraw
