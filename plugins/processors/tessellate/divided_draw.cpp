#include "divided_draw.h"

#include "coarser_levels.h"
#include "tessellate.h"

#include <foredraw/displaced/level_counts.h>
#include <foredraw/displaced/scaled_levels.h>
#include <foredraw/displaced/seamed_displacements.h>
#include <foredraw/displaced/stored_levels.h>

#include <array>
#include <utility>

namespace foredraw {

namespace {

std::string too_many(std::span<const TessellationLevels> levels, TessellationSpacing spacing, int most) {
  const std::uint64_t triangles = count_triangles(levels, spacing);
  if (triangles <= static_cast<std::uint64_t>(most)) return {};
  return std::to_string(triangles) + " triangles would come out, more than the limit of " + std::to_string(most) +
         "; give a larger `texels`, a lower `parts` or a higher `most`";
}

/// As the options say, or else those that a stage chose, or as fine as the map.
std::vector<TessellationLevels> levels_of(const Level& level, std::span<const std::array<std::int32_t, 2>> places,
                                          const DrawTessellation* chosen, const DivisionOptions& options) {
  const auto indices = level.stream().indices.view();
  if (options.parts) {
    const float parts = *options.parts;
    return std::vector<TessellationLevels>(indices.size() / 3, {{parts, parts, parts}, parts});
  }
  if (chosen != nullptr && !options.texels) return scaled_levels(*chosen, 0);
  return levels_by_texels(indices, decode_vec3(*level.vertices->find("POSITION")), places,
                          options.texels.value_or(usual_texels_per_part));
}

/// Divides one draw, by its map (`map` is set) or its baked heights.
class DrawDivision {
 public:
  DrawDivision(const Scene& scene, DrawId id, TessellationSpacing spacing, const LaidOutMap* map,
               const DrawHeights* heights, Analyses& analyses)
      : level_(scene.draws[id].full()),
        spacing_(spacing),
        map_(map),
        heights_(heights),
        directions_(displacement_directions(scene, id, analyses)) {
    const Material* material = scene.material_of(scene.draws[id]);
    if (const DrawSeams* seams = seams_of(scene, id)) seams_.emplace(*seams);
    keeps_normals_ = material != nullptr && material->normal_map;
  }

  DividedDraw run(std::vector<TessellationLevels> levels, int most_levels) const {
    DividedDraw divided;
    const TessellatedMesh finest = mesh_of(levels);
    divided.levels.push_back(own_vertices(finest));
    divided.source = sources_of(levels, spacing_);
    while (divided.levels.size() < static_cast<std::size_t>(most_levels)) {
      std::vector<TessellationLevels> half = halved(levels);
      if (half == levels) break;
      levels = std::move(half);
      const TessellatedMesh mesh = mesh_of(levels);
      // 2.75 and 1.375 are both in three parts, where spacing is fractional odd.
      if (mesh.indices.size() == divided.levels.back().indices.size()) continue;
      auto indices = by_vertices_of(finest, mesh);
      divided.levels.push_back(indices ? DividedLevel{divided.levels.front().vertices, std::move(*indices)}
                                       : own_vertices(mesh));
    }
    return divided;
  }

 private:
  std::span<const std::uint32_t> indices() const { return level_.stream().indices.view(); }

  TessellatedMesh mesh_of(std::span<const TessellationLevels> levels) const {
    return tessellated_mesh(indices(), level_.vertices->count, levels, spacing_);
  }

  DividedLevel own_vertices(const TessellatedMesh& mesh) const {
    Tessellated made = tessellate(*level_.vertices, indices(), directions_, mesh, moved_by(mesh), keeps_normals_);
    return {std::make_shared<const VertexStreams>(std::move(made.vertices)), std::move(made.indices)};
  }

  /// Baked heights belong to the points of the finest mesh; coarser ones have no others.
  std::vector<float> moved_by(const TessellatedMesh& mesh) const {
    if (heights_ != nullptr)
      return height_displacements(heights_->heights.view(), heights_->bits, heights_->factor, heights_->offset);
    const auto [factor, offset] = std::pair(map_->displacement.factor, map_->displacement.offset);
    if (seams_) return seamed_displacements(mesh, indices(), map_->places, map_->sampled(), factor, offset, *seams_);
    return displacements(mesh, indices(), map_->places, map_->sampled(), factor, offset);
  }

  const Level& level_;
  TessellationSpacing spacing_;
  const LaidOutMap* map_;
  const DrawHeights* heights_;
  std::optional<StoredSeams> seams_;
  std::vector<glm::vec3> directions_;
  bool keeps_normals_ = false;
};

}  // namespace

std::variant<DividedDraw, std::string> divided_draw(const Scene& scene, DrawId id, const DivisionOptions& options,
                                                    Analyses& analyses) {
  const Level& level = scene.draws[id].full();
  const DrawHeights* heights = heights_of(scene, id);
  std::optional<LaidOutMap> map;
  std::vector<TessellationLevels> levels;
  if (heights != nullptr) {
    levels = baked_levels(heights->levels.view(), level.stream().indices.view(),
                          decode_vec3(*level.vertices->find("POSITION")));
  } else {
    auto found = laid_out_map(scene, id, analyses);
    if (std::string* why = std::get_if<std::string>(&found)) return std::move(*why);
    map = std::get<LaidOutMap>(std::move(found));
    levels = levels_of(level, map->places, tessellation_of(scene, id), options);
  }
  const TessellationSpacing spacing = heights != nullptr ? TessellationSpacing::equal : options.spacing;
  if (std::string why = too_many(levels, spacing, options.most); !why.empty()) return why;
  const DrawDivision division(scene, id, spacing, map ? &*map : nullptr, heights, analyses);
  return division.run(std::move(levels), options.levels);
}

}  // namespace foredraw
