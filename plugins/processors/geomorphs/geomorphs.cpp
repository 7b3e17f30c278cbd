#include "geomorphs.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/scene/draw.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace foredraw {

std::vector<std::uint32_t> ancestors(const CutDraw& fine, const CutDraw& coarse, const Collapsed& at_coarse,
                                     const JoinedMesh& mesh) {
  std::vector<bool> is_drawn(coarse.origin.size(), false);
  for (const std::uint32_t index : coarse.indices.view()) is_drawn[index] = true;
  const std::vector<std::uint32_t> point = welded(mesh.positions);
  std::vector<std::uint32_t> at_vertex(mesh.positions.size(), no_vertex), at_point(mesh.positions.size(), no_vertex);
  for (std::uint32_t v = 0; v < coarse.origin.size(); ++v) {
    if (!is_drawn[v]) continue;
    at_vertex[coarse.origin[v]] = v;
    std::uint32_t& first = at_point[point[coarse.origin[v]]];
    first = std::min(first, v);
  }
  // [point] where one of its vertices has gone: a vertex that no triangle used by then is left behind, and goes there.
  std::vector<std::uint32_t> gone_to(point.size(), no_vertex);
  for (std::uint32_t v = 0; v < point.size(); ++v) {
    const std::uint32_t to = point[at_coarse.vertex[v]];
    if (to != point[v] && gone_to[point[v]] == no_vertex) gone_to[point[v]] = to;
  }
  const auto point_now = [&](std::uint32_t vertex) {
    std::uint32_t at = point[vertex];
    while (at_point[at] == no_vertex && gone_to[at] != no_vertex) at = gone_to[at];
    return at;
  };
  const auto nearest = [&](glm::vec3 place) {
    const auto distance = [&](std::uint32_t v) {
      const glm::dvec3 apart = glm::dvec3(at_coarse.places[coarse.origin[v]]) - glm::dvec3(place);
      return dot(apart, apart);
    };
    std::uint32_t best = no_vertex;
    for (std::uint32_t v = 0; v < coarse.origin.size(); ++v) {
      if (is_drawn[v] && (best == no_vertex || distance(v) < distance(best))) best = v;
    }
    return best == no_vertex ? 0 : best;
  };
  std::vector<std::uint32_t> result;
  std::unordered_map<std::uint32_t, std::uint32_t> of_lost;  // points that no triangle has any more
  for (const std::uint32_t origin : fine.origin) {
    const std::uint32_t stands = at_coarse.vertex[origin];
    if (at_vertex[stands] != no_vertex) {
      result.push_back(at_vertex[stands]);
    } else if (const std::uint32_t at = point_now(stands); at_point[at] != no_vertex) {
      result.push_back(at_point[at]);
    } else {
      const auto [known, is_new] = of_lost.try_emplace(at, 0);
      if (is_new) known->second = nearest(at_coarse.places[stands]);
      result.push_back(known->second);
    }
  }
  return result;
}

std::optional<CutLevel> find_cut(const CollapseSequence& sequence, const Replay& run, const JoinedMesh& mesh,
                                 const std::vector<const Level*>& levels) {
  std::uint32_t triangles = 0;
  for (const Level* level : levels) triangles += static_cast<std::uint32_t>(level->stream().triangle_count());
  const auto [first, end] = std::equal_range(run.triangles.begin(), run.triangles.end(), triangles, std::greater<>());
  const bool same_vertices = leaves_vertices(sequence, mesh);
  for (auto at = first; at != end; ++at) {
    const auto collapses = static_cast<std::size_t>(at - run.triangles.begin());
    CutLevel level{collapsed(sequence, collapses, mesh), {}};
    level.draws = same_vertices ? cut_of_same_vertices(level.after, mesh) : cut(sequence, collapses, level.after, mesh);
    const bool is_it = std::ranges::equal(level.draws, levels, [](const CutDraw& draw, const Level* wanted) {
      return draw.indices == wanted->stream().indices &&
             (draw.vertices == wanted->vertices || draw.vertices->stamp() == wanted->vertices->stamp());
    });
    if (is_it) return level;
  }
  return std::nullopt;
}

}  // namespace foredraw
