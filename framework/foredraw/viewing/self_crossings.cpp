#include <foredraw/viewing/self_crossings.h>

#include <foredraw/analysis/crossing_triangles.h>
#include <foredraw/viewing/displaced_draw.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 19;

}  // namespace

std::optional<SelfCrossings> self_crossings(const Scene& scene, DrawId draw, Analyses& analyses,
                                            const Executor& executor, const std::atomic<bool>* cancel) {
  const Level& level = scene.draws[draw].full();
  if (level.stream().triangle_count() > most_triangles) return std::nullopt;
  const auto displaced = displaced_draw_of(scene, draw, analyses);
  if (displaced == nullptr) return std::nullopt;
  const std::vector<glm::vec3> stored = decode_vec3(*level.vertices->find("POSITION"));
  const auto indices = level.stream().indices.view();
  const std::vector<glm::vec3> shown =
      displaced_positions(displaced->mesh, indices, stored, displaced->directions, displaced->displacements);
  const auto before = crossing_triangles({stored, indices}, executor, cancel);
  const auto after = crossing_triangles({shown, displaced->mesh.indices}, executor, cancel);
  if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return std::nullopt;
  SelfCrossings found{after.size(), 0};
  for (std::size_t t = 0; t < after.size(); ++t) found.crossing += after[t] != 0 && before[displaced->owners[t]] == 0;
  return found;
}

std::string note_of(const std::optional<SelfCrossings>& found) {
  if (!found || found->crossing == 0) return {};
  return "the surface passes through itself: of the " + std::to_string(found->triangles) + " triangles that show it, " +
         std::to_string(found->crossing) +
         " pass through others, which their triangles as stored do not; a smaller factor helps";
}

}  // namespace foredraw
