#include "touching_draws.h"

#include <foredraw/geometry/box.h>
#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace foredraw {

namespace {

using Cell = std::array<std::int64_t, 3>;

glm::dvec3 in_world(const glm::mat4& world, const glm::vec3& position) {
  return glm::dvec3(glm::dmat4(world) * glm::dvec4(glm::dvec3(position), 1.0));
}

bool is_fixed(const Scene& scene, const Node& node, DrawId draw) {
  return !node.skin && node.instances.empty() && scene.draws[draw].full().vertices->morph_targets.empty();
}

using WorldBox = Box<glm::dvec3>;

WorldBox grown(const WorldBox& box, double by) { return {box.min - by, box.max + by}; }

WorldBox shared_box(const WorldBox& a, const WorldBox& b) { return {glm::max(a.min, b.min), glm::min(a.max, b.max)}; }

bool is_in(const WorldBox& box, const glm::dvec3& p) {
  return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x && p.y <= box.max.y &&
         p.z <= box.max.z;
}

/// A draw as a node places it, and where it may meet others: the box of what its box shares with theirs.
struct Placed {
  DrawId draw = 0;
  NodeId node = 0;
  std::shared_ptr<const Positions> positions;
  WorldBox box, shared;
};

std::vector<Placed> placed_draws(const Scene& scene, const std::vector<DrawId>& draws,
                                 const std::vector<glm::mat4>& worlds, Analyses& analyses) {
  std::vector<Placed> placed;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    if (!scene.nodes[n].mesh) continue;
    for (const DrawId id : scene.meshes[*scene.nodes[n].mesh].draws) {
      if (!std::ranges::binary_search(draws, id) || !is_fixed(scene, scene.nodes[n], id)) continue;
      Placed one{id, n, positions_of(analyses, *scene.draws[id].full().vertices), {}, {}};
      for (const glm::vec3& position : one.positions->values) {
        const glm::dvec3 at = in_world(worlds[n], position);
        if (is_finite(glm::vec3(at))) one.box.add(at);
      }
      if (!one.box.is_empty()) placed.push_back(std::move(one));
    }
  }
  return placed;
}

/// Boxes that are nearer than `near` to each other, found in the sequence of their left sides.
void find_shared(std::vector<Placed>& placed, double near) {
  std::ranges::stable_sort(placed, {}, [](const Placed& one) { return one.box.min.x; });
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const WorldBox near_it = grown(placed[i].box, near);
    for (std::size_t j = i + 1; j < placed.size() && placed[j].box.min.x <= near_it.max.x; ++j) {
      const WorldBox shared = shared_box(near_it, grown(placed[j].box, near));
      if (!(shared.min.y <= shared.max.y && shared.min.z <= shared.max.z)) continue;
      for (Placed* one : {&placed[i], &placed[j]}) {
        one->shared.add(shared.min);
        one->shared.add(shared.max);
      }
    }
  }
}

using MetCell = std::pair<Cell, MetPoint>;

std::uint64_t hash_of(const Cell& cell) {
  std::uint64_t hash = 0;
  for (const std::int64_t number : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Leaves out cells that one placed draw alone has, which are most of them; some whose hashes agree with another's
/// stay.
void leave_out_lonely(std::vector<MetCell>& cells) {
  enum class Met : std::uint8_t { nobody, one, several };
  struct Place {
    Met met = Met::nobody;
    NodeId node = 0;
    DrawId draw = 0;
  };
  std::vector<Place> places(std::bit_ceil(2 * cells.size()));
  const auto place_of = [&](const Cell& cell) -> Place& { return places[hash_of(cell) & (places.size() - 1)]; };
  for (const auto& [cell, point] : cells) {
    Place& place = place_of(cell);
    if (place.met == Met::nobody) place = {Met::one, point.node, point.draw};
    if (place.node != point.node || place.draw != point.draw) place.met = Met::several;
  }
  std::erase_if(cells, [&](const MetCell& one) { return place_of(one.first).met != Met::several; });
}

}  // namespace

std::vector<Meeting> meetings_of(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  std::vector<Placed> placed = placed_draws(scene, draws, worlds, analyses);
  WorldBox all;
  for (const Placed& one : placed) all.add(one.box);
  const glm::dvec3 extent = all.extent();
  const double near = std::max(extent.x, std::max(extent.y, extent.z)) * 1e-6;
  if (placed.size() < 2 || !(near > 0)) return {};
  find_shared(placed, near);
  std::vector<MetCell> cells;
  for (const Placed& one : placed) {
    for (std::uint32_t v = 0; v < one.positions->values.size() && !one.shared.is_empty(); ++v) {
      const glm::dvec3 at = in_world(worlds[one.node], one.positions->values[v]);
      if (!is_in(one.shared, at)) continue;
      const glm::dvec3 number = (at - all.min) / near;
      cells.push_back(
          {{std::llround(number.x), std::llround(number.y), std::llround(number.z)}, {one.draw, one.node, v}});
    }
  }
  if (cells.empty()) return {};
  leave_out_lonely(cells);
  std::ranges::sort(cells, [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.node, a.second.draw, a.second.vertex) <
           std::tie(b.first, b.second.node, b.second.draw, b.second.vertex);
  });
  std::vector<Meeting> meetings;
  for (std::size_t i = 1, first = 0; i < cells.size(); ++i) {
    if (cells[i].first != cells[first].first) first = i;
    const MetPoint &at = cells[first].second, &with = cells[i].second;
    if (at.draw != with.draw || at.node != with.node) meetings.push_back({at, with});
  }
  return meetings;
}

double largest_gap(const Scene& rounded, const std::vector<Meeting>& meetings, const std::vector<NodeId>& drawn_by,
                   Analyses& analyses) {
  const std::vector<glm::mat4> worlds = world_transforms(rounded);
  const auto place = [&](const MetPoint& point) {
    const auto positions = positions_of(analyses, *rounded.draws[point.draw].full().vertices);
    return in_world(worlds[drawn_by[point.node]], positions->values[point.vertex]);
  };
  double largest = 0;
  for (const Meeting& meeting : meetings) {
    const glm::dvec3 off = place(meeting.at) - place(meeting.with);
    largest = std::max(largest, off.x * off.x + off.y * off.y + off.z * off.z);
  }
  return std::sqrt(largest);
}

}  // namespace foredraw
