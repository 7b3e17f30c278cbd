#include <foredraw/viewing/displaced_draw.h>

#include <foredraw/displaced/level_counts.h>
#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/displaced/stored_levels.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/mat3x3.hpp>

#include <algorithm>

namespace foredraw {

namespace {

/// Of one draw: its silhouette is then as fine as what viewers show of it, and views are still drawn in no time.
constexpr std::size_t most_triangles = std::size_t{1} << 19;

constexpr TessellationSpacing spacing = TessellationSpacing::equal;

std::vector<TessellationLevels> shown_levels(const Draw& draw, std::span<const std::array<std::int32_t, 2>> places) {
  const std::vector<glm::vec3> positions = decode_vec3(*draw.full().vertices->find("POSITION"));
  for (double texels = usual_texels_per_part;; texels *= 2) {
    auto levels = levels_by_texels(draw.full().stream().indices.view(), positions, places, texels);
    if (count_triangles(levels, spacing) <= std::max(most_triangles, levels.size())) return levels;
  }
}

DisplacedDraw by_map(const Draw& draw, const LaidOutMap& map) {
  const auto indices = draw.full().stream().indices.view();
  const std::vector<TessellationLevels> levels = shown_levels(draw, map.places);
  DisplacedDraw result;
  result.mesh = tessellated_mesh(indices, draw.full().vertices->count, levels, spacing);
  result.displacements =
      displacements(result.mesh, indices, map.places, map.sampled(), map.displacement.factor, map.displacement.offset);
  result.owners = sources_of(levels, spacing);
  return result;
}

DisplacedDraw by_heights(const Level& level, const DrawHeights& heights) {
  return {tessellated_mesh(heights, level),
          height_displacements(heights.heights.view(), heights.bits, heights.factor, heights.offset),
          {},
          sources_of(baked_levels(heights.levels.view(), level.stream().indices.view(),
                                  decode_vec3(*level.vertices->find("POSITION"))),
                     spacing)};
}

Stamp stamp_of(const Level& level, const DrawHeights& heights) {
  const float numbers[] = {heights.factor, heights.offset, static_cast<float>(heights.bits)};
  const Stamp parts[] = {level.vertices->stamp(), level.stream().indices.stamp(), heights.levels.stamp(),
                         heights.heights.stamp(), content_hash(std::span<const float>(numbers))};
  return combine(parts);
}

}  // namespace

std::size_t DisplacedDraw::bytes() const {
  return mesh.samples.size() * sizeof(SurfaceSample) + directions.size() * sizeof(glm::vec3) +
         sizeof(std::uint32_t) * (mesh.indices.size() + displacements.size() + owners.size());
}

std::shared_ptr<const DisplacedDraw> displaced_draw_of(const Scene& scene, DrawId id, Analyses& analyses) {
  const Draw& draw = scene.draws[id];
  const auto directed = [&](DisplacedDraw made) {
    made.directions = displacement_directions(scene, id, analyses);
    return made;
  };
  if (const DrawHeights* heights = heights_of(scene, id)) {
    return analyses.get<DisplacedDraw>(stamp_of(draw.full(), *heights),
                                       [&] { return directed(by_heights(draw.full(), *heights)); });
  }
  const Material* material = scene.material_of(draw);
  if (material == nullptr || !material->displacement) return nullptr;
  const auto map = laid_out_map(scene, id, analyses);
  if (std::holds_alternative<std::string>(map)) return nullptr;
  return analyses.get<DisplacedDraw>(displacement_stamp(scene, id),
                                     [&] { return directed(by_map(draw, std::get<LaidOutMap>(map))); });
}

std::vector<glm::vec3> posed_positions(const DisplacedDraw& displaced, std::span<const glm::vec3> posed,
                                       const Scene& scene, const SubjectPart& part, const PosedNodes& nodes) {
  std::vector<glm::vec3> directions = displaced.directions;
  if (part.node) {
    const std::vector<glm::dmat4x3> maps = vertex_maps(scene, part, nodes);
    for (std::size_t v = 0; v < directions.size(); ++v) directions[v] = glm::dmat3(maps[v]) * glm::dvec3(directions[v]);
  }
  return displaced_positions(displaced.mesh, scene.draws[part.draw].full().stream().indices.view(), posed, directions,
                             displaced.displacements);
}

SeenSurface seen_surface(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes, Analyses& analyses) {
  SeenSurface seen{displaced_draw_of(scene, part.draw, analyses), posed_positions(scene, part, nodes),
                   scene.draws[part.draw].full().stream().indices.view()};
  if (seen.displaced) {
    seen.positions = posed_positions(*seen.displaced, seen.positions, scene, part, nodes);
    seen.indices = seen.displaced->mesh.indices;
  }
  return seen;
}

}  // namespace foredraw
