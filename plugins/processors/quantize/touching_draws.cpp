#include "touching_draws.h"

#include <foredraw/analysis/mesh_facts.h>
#include <foredraw/analysis/seam_edges.h>

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace foredraw {

namespace {

using Cell = std::array<std::int64_t, 3>;

/// Vertices at the ends of edges that have one triangle.
std::vector<std::uint32_t> border_vertices(const Draw& draw, std::span<const glm::vec3> positions) {
  const std::vector<glm::vec2> no_layout(positions.size());
  const UvMesh mesh{positions, no_layout, draw.full().stream().indices.view()};
  std::vector<std::uint32_t> border;
  for (const SharedEdge& edge : seam_edges({&mesh, 1}).edges) {
    if (edge.kind == EdgeKind::border) border.insert(border.end(), edge.points.begin(), edge.points.end());
  }
  std::ranges::sort(border);
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

glm::dvec3 in_world(const glm::mat4& world, const glm::vec3& position) {
  return glm::dvec3(glm::dmat4(world) * glm::dvec4(glm::dvec3(position), 1.0));
}

bool is_fixed(const Scene& scene, const Node& node, DrawId draw) {
  return !node.skin && node.instances.empty() && scene.draws[draw].full().vertices->morph_targets.empty();
}

struct Placed {
  BorderPoint point;
  glm::dvec3 position;
};

std::vector<Placed> placed_borders(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  std::map<DrawId, std::vector<std::uint32_t>> borders;
  std::vector<Placed> placed;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    if (!scene.nodes[n].mesh) continue;
    for (const DrawId id : scene.meshes[*scene.nodes[n].mesh].draws) {
      if (!std::ranges::binary_search(draws, id) || !is_fixed(scene, scene.nodes[n], id)) continue;
      const auto positions = positions_of(analyses, *scene.draws[id].full().vertices);
      const auto [border, is_new] = borders.try_emplace(id);
      if (is_new) border->second = border_vertices(scene.draws[id], positions->values);
      for (const std::uint32_t v : border->second) {
        const glm::dvec3 at = in_world(worlds[n], positions->values[v]);
        if (is_finite(glm::vec3(at))) placed.push_back({{id, n, v}, at});
      }
    }
  }
  return placed;
}

}  // namespace

std::vector<Meeting> meetings_of(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses) {
  const std::vector<Placed> placed = placed_borders(scene, draws, analyses);
  if (placed.empty()) return {};
  glm::dvec3 least = placed.front().position, most = least;
  for (const Placed& one : placed) {
    least = glm::min(least, one.position);
    most = glm::max(most, one.position);
  }
  const glm::dvec3 extent = most - least;
  const double size = std::max(extent.x, std::max(extent.y, extent.z));
  if (!(size > 0)) return {};
  std::vector<std::pair<Cell, std::size_t>> cells(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const glm::dvec3 number = (placed[i].position - least) / (size * 1e-6);
    cells[i] = {{std::llround(number.x), std::llround(number.y), std::llround(number.z)}, i};
  }
  std::ranges::sort(cells);
  std::vector<Meeting> meetings;
  for (std::size_t i = 1, first = 0; i < cells.size(); ++i) {
    if (cells[i].first != cells[first].first) first = i;
    const BorderPoint &at = placed[cells[first].second].point, &with = placed[cells[i].second].point;
    if (at.draw != with.draw || at.node != with.node) meetings.push_back({at, with});
  }
  return meetings;
}

double largest_gap(const Scene& rounded, const std::vector<Meeting>& meetings, Analyses& analyses) {
  const std::vector<glm::mat4> worlds = world_transforms(rounded);
  const auto place = [&](const BorderPoint& point) {
    const auto positions = positions_of(analyses, *rounded.draws[point.draw].full().vertices);
    return in_world(worlds[point.node], positions->values[point.vertex]);
  };
  double largest = 0;
  for (const Meeting& meeting : meetings) {
    const glm::dvec3 off = place(meeting.at) - place(meeting.with);
    largest = std::max(largest, off.x * off.x + off.y * off.y + off.z * off.z);
  }
  return std::sqrt(largest);
}

}  // namespace foredraw
