#include <foredraw/viewing/self_crossings.h>

#include <foredraw/analysis/crossing_triangles.h>
#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/level_counts.h>
#include <foredraw/displaced/scene_displacement.h>

#include <algorithm>

namespace foredraw {

namespace {

/// Enough to see folds, and answered in less than a second.
constexpr std::size_t most_triangles = std::size_t{1} << 17;

constexpr TessellationSpacing spacing = TessellationSpacing::equal;

/// As fine as the map, or less, so that there are not too many.
std::vector<TessellationLevels> asked_levels(const Level& level, std::span<const glm::vec3> positions,
                                             const LaidOutMap& map) {
  for (double texels = usual_texels_per_part;; texels *= 2) {
    auto levels = levels_by_texels(level.stream().indices.view(), positions, map.places, texels);
    if (count_triangles(levels, spacing) <= std::max(most_triangles, levels.size())) return levels;
  }
}

}  // namespace

std::optional<SelfCrossings> self_crossings(const Scene& scene, DrawId draw, Analyses& analyses,
                                            const Executor& executor, const std::atomic<bool>* cancel) {
  const Level& level = scene.draws[draw].full();
  if (level.stream().triangle_count() > most_triangles) return std::nullopt;
  const auto found_map = laid_out_map(scene, draw, analyses);
  if (std::holds_alternative<std::string>(found_map)) return std::nullopt;
  const LaidOutMap& map = std::get<LaidOutMap>(found_map);
  const std::vector<glm::vec3> stored = decode_vec3(*level.vertices->find("POSITION"));
  const auto indices = level.stream().indices.view();
  const std::vector<TessellationLevels> levels = asked_levels(level, stored, map);
  const TessellatedMesh mesh = tessellated_mesh(indices, level.vertices->count, levels, spacing);
  const std::vector<float> moves =
      displacements(mesh, indices, map.places, map.sampled(), map.displacement.factor, map.displacement.offset);
  const std::vector<glm::vec3> moved =
      displaced_positions(mesh, indices, stored, displacement_directions(scene, draw, analyses), moves);
  const auto before = crossing_triangles({stored, indices}, executor, cancel);
  const auto after = crossing_triangles({moved, mesh.indices}, executor, cancel);
  if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return std::nullopt;
  const std::vector<std::uint32_t> sources = sources_of(levels, spacing);
  SelfCrossings found{after.size(), 0};
  for (std::size_t t = 0; t < after.size(); ++t) found.crossing += after[t] != 0 && before[sources[t]] == 0;
  return found;
}

std::string note_of(const std::optional<SelfCrossings>& found) {
  if (!found || found->crossing == 0) return {};
  return "the surface passes through itself: divided into " + std::to_string(found->triangles) + " triangles, " +
         std::to_string(found->crossing) +
         " of them pass through others, which the stored ones do not; a smaller factor helps";
}

}  // namespace foredraw
