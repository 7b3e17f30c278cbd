#include <foredraw/analysis/scene_facts.h>

#include <foredraw/scene/vertex_groups.h>

#include <algorithm>

namespace foredraw {

namespace {

std::size_t count_unreferenced(const Scene& scene, const VertexGroup& group) {
  std::vector<bool> is_referenced(group.vertices->count, false);
  for (const auto indices : index_streams_of(scene, group)) {
    for (const std::uint32_t vertex : indices) is_referenced[vertex] = true;
  }
  return static_cast<std::size_t>(std::ranges::count(is_referenced, false));
}

}  // namespace

std::vector<MeshFacts> facts_of_draws(const Scene& scene, Analyses& analyses, const Executor& executor) {
  std::vector<MeshFacts> facts(scene.draws.size());
  const auto draws_triangles = [&](DrawId draw) { return scene.draws[draw].topology == Topology::triangles; };
  executor.for_each(scene.draws.size(), [&](std::size_t draw) {
    if (!draws_triangles(static_cast<DrawId>(draw))) return;
    const auto positions = positions_of(analyses, *scene.draws[draw].full().vertices);
    facts[draw] = mesh_facts(positions->values, scene.draws[draw].full().stream().indices.view());
  });
  const std::vector<VertexGroup> groups = vertex_groups(scene);
  executor.for_each(groups.size(), [&](std::size_t i) {
    bool is_first = true;
    for (const auto& [draw, level] : groups[i].users) {
      if (level > 0 || !draws_triangles(draw)) continue;
      facts[draw].unreferenced_vertices = is_first ? count_unreferenced(scene, groups[i]) : 0;
      if (!is_first) facts[draw].non_finite_positions = 0;
      is_first = false;
    }
  });
  return facts;
}

std::size_t count_vertices(const Scene& scene) {
  std::size_t count = 0;
  for (const VertexGroup& group : vertex_groups(scene)) {
    const bool is_full = std::ranges::any_of(group.users, [](const auto& user) { return user.level == 0; });
    if (is_full) count += group.vertices->count;
  }
  return count;
}

}  // namespace foredraw
