#include "scene_wires.h"

#include "wire_streams.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/scene/skin_weights.h>
#include <foredraw/scene/vertex_groups.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw::processors::wire_radius {

namespace {

/// Empty: its wires may be taken.
std::string why_left(const Scene& scene, const Draw& draw) {
  if (draw.topology != Topology::triangles) return "it draws lines or points, whose width is not known";
  if (draw.full().orders.size() > 1) return "it has several orders of its triangles";
  if (draw.traits.has(traits::morphed)) return "morph targets may move its vertices and not their centre line";
  const Material* material = scene.material_of(draw);
  if (material != nullptr && material->alpha_mode == AlphaMode::blend) return "it is blended already";
  if (material != nullptr && material->alpha_mode == AlphaMode::mask) {
    return "an image cuts out its shape, which its vertices do not show";
  }
  return {};
}

/// Whether the vertices next to each other round a section follow the same joints.
class Rings {
 public:
  Rings(const Scene& scene, const WireUnit& unit) {
    for (const DrawId id : unit.draws) weights_.emplace_back(*scene.draws[id].full().vertices);
  }

  bool are_alike(std::size_t draw, std::uint32_t a, std::uint32_t b) const {
    const SkinWeights& weights = weights_[draw];
    if (weights.empty()) return true;
    constexpr float least = 0.02f;
    const auto has = [&](std::uint32_t vertex, const SkinWeights::Slot& slot) {
      float sum = 0;
      for (const SkinWeights::Slot& other : weights.of(vertex)) sum += other.joint == slot.joint ? other.weight : 0;
      return std::abs(sum - slot.weight) < least;
    };
    return std::ranges::all_of(weights.of(a), [&](const auto& slot) { return slot.weight < least || has(b, slot); }) &&
           std::ranges::all_of(weights.of(b), [&](const auto& slot) { return slot.weight < least || has(a, slot); });
  }

 private:
  std::vector<SkinWeights> weights_;
};

struct Joined {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

void append(const Scene& scene, DrawId id, Analyses& analyses, Joined& to) {
  const Draw& draw = scene.draws[id];
  if (draw.topology != Topology::triangles) return;
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  const auto positions = positions_of(analyses, *draw.full().vertices);
  to.positions.insert(to.positions.end(), positions->values.begin(), positions->values.end());
  to.positions.resize(first + draw.full().vertices->count);  // of a draw without positions: no triangle is one
  for (const std::uint32_t index : draw.full().stream().indices.view()) to.indices.push_back(first + index);
}

/// Takes wires out again, with what only they moved.
void leave_out(FoundWires& found, std::span<const std::uint32_t> indices, const std::vector<bool>& is_out) {
  std::vector<bool> is_used(found.half_width.size(), false);
  for (std::size_t t = 0; t < found.wire_of.size(); ++t) {
    std::uint32_t& wire = found.wire_of[t];
    if (wire != FoundWires::none && is_out[wire]) wire = FoundWires::none;
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i)
      is_used[indices[i]] = is_used[indices[i]] || wire != FoundWires::none;
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v]) continue;
    found.half_width[v] = 0;
    found.to_centre[v] = found.axis[v] = glm::vec3(0);
    found.is_flat[v] = false;
  }
}

/// [triangle] Those of no wire that hang together with one, over all draws.
std::vector<bool> torn(const Joined& mesh, const std::vector<std::uint32_t>& wire_of) {
  const std::vector<std::uint32_t> first = welded(mesh.positions);
  JoinedSets shells(mesh.positions.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (const std::size_t other : {i + 1, i + 2}) shells.join(first[mesh.indices[i]], first[mesh.indices[other]]);
  }
  const auto shell_of = [&](std::size_t t) { return shells.of(first[mesh.indices[3 * t]]); };
  std::vector<bool> has_wire(mesh.positions.size(), false), result(wire_of.size(), false);
  for (std::size_t t = 0; t < wire_of.size(); ++t) {
    if (wire_of[t] != FoundWires::none) has_wire[shell_of(t)] = true;
  }
  for (std::size_t t = 0; t < wire_of.size(); ++t) {
    result[t] = wire_of[t] == FoundWires::none && has_wire[shell_of(t)];
  }
  return result;
}

/// Corners of a draw of the unit that want a copy of their vertex.
std::span<const FoundWires::Corner> corners_of(const UnitWires& wires, std::size_t draw) {
  const auto& all = wires.found.corners;
  const auto at = [&](std::size_t triangle) {
    return std::ranges::lower_bound(all, 3 * triangle, {}, &FoundWires::Corner::index);
  };
  return {at(wires.first_triangle[draw]), at(wires.first_triangle[draw + 1])};
}

void add_copies(const UnitWires& wires, std::size_t draw, std::vector<CopiedVertex>& to) {
  std::vector<std::uint32_t> numbers;
  for (const FoundWires::Corner& corner : corners_of(wires, draw)) {
    if (wires.found.wire_of[corner.index / 3] != FoundWires::none) numbers.push_back(corner.copy);
  }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  const auto first = static_cast<std::uint32_t>(wires.first_vertex[draw]);
  for (const std::uint32_t number : numbers) to.push_back({wires.found.copies[number].vertex - first, number});
}

/// Leads corners to copies, which stand behind `count` vertices.
void take_copies(Draw& draw, std::uint32_t count, const UnitWires& wires, std::size_t number,
                 std::span<const CopiedVertex> copies) {
  const std::span<const FoundWires::Corner> corners = corners_of(wires, number);
  if (corners.empty()) return;
  std::map<std::uint32_t, std::uint32_t> place;
  for (std::uint32_t i = 0; i < copies.size(); ++i) place[copies[i].copy] = count + i;
  IndexStream& stream = draw.full().stream();
  const auto before = stream.indices.view();
  std::vector<std::uint32_t> indices(before.begin(), before.end());
  for (const FoundWires::Corner& corner : corners) {
    if (wires.found.wire_of[corner.index / 3] == FoundWires::none) continue;
    indices[corner.index - 3 * wires.first_triangle[number]] = place.at(corner.copy);
  }
  stream.indices = Shared(std::move(indices));
}

}  // namespace

WireUnits wire_units(const Scene& scene, const std::vector<DrawId>& draws) {
  JoinedSets sets(scene.draws.size());
  for (const Mesh& mesh : scene.meshes) {
    for (const DrawId id : mesh.draws) sets.join(mesh.draws.front(), id);
  }
  // What follows one skin lies in one space, wherever its nodes are.
  std::map<SkinId, DrawId> first_of_skin;
  for (const Node& node : scene.nodes) {
    if (!node.skin || !node.mesh || scene.meshes[*node.mesh].draws.empty()) continue;
    const DrawId first = scene.meshes[*node.mesh].draws.front();
    sets.join(first_of_skin.try_emplace(*node.skin, first).first->second, first);
  }
  for (const VertexGroup& group : vertex_groups(scene)) {
    for (const VertexGroup::User& user : group.users) sets.join(group.users.front().draw, user.draw);
  }
  // Streams that somebody draws from who must not be changed can not be changed.
  std::vector<VertexGroup> groups = vertex_groups(scene);
  std::vector<bool> is_held(scene.draws.size(), false);
  for (const HeldDraw& held : keep_groups_of(groups, draws)) is_held[held.draw] = true;
  WireUnits result;
  std::map<std::uint32_t, std::size_t> unit_of;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const auto [place, is_new] = unit_of.try_emplace(sets.of(id), result.units.size());
    if (is_new) result.units.emplace_back();
    WireUnit& unit = result.units[place->second];
    const bool is_asked = std::ranges::binary_search(draws, id);
    std::string why =
        is_held[id] ? "a draw that must not change shares its vertices" : why_left(scene, scene.draws[id]);
    if (is_asked && why.empty()) {
      unit.draws.push_back(id);
    } else {
      unit.fixed.push_back(id);
      if (is_asked) result.left.push_back({id, std::move(why)});
    }
  }
  std::erase_if(result.units, [](const WireUnit& unit) { return unit.draws.empty(); });
  return result;
}

UnitWires find_unit_wires(const Scene& scene, const WireUnit& unit, const WireOptions& options,
                          const WireSearch& search, Analyses& analyses) {
  Joined mesh;
  UnitWires wires;
  for (const DrawId id : unit.draws) {
    wires.first_vertex.push_back(mesh.positions.size());
    wires.first_triangle.push_back(mesh.indices.size() / 3);
    append(scene, id, analyses, mesh);
  }
  const std::size_t triangles = mesh.indices.size() / 3, vertices = mesh.positions.size();
  wires.first_vertex.push_back(vertices);
  wires.first_triangle.push_back(triangles);
  for (const DrawId id : unit.fixed) append(scene, id, analyses, mesh);
  FoundWires& found = wires.found;
  found = find_wires(mesh.positions, mesh.indices, options, search, triangles);

  const Rings rings(scene, unit);
  std::vector<bool> is_bent(found.wires.size(), false);
  for (std::size_t d = 0; d < unit.draws.size(); ++d) {
    for (std::size_t t = wires.first_triangle[d]; t < wires.first_triangle[d + 1]; ++t) {
      if (found.wire_of[t] == FoundWires::none) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = mesh.indices[3 * t + i], b = mesh.indices[3 * t + (i + 1) % 3];
        const glm::vec3 apart = mesh.positions[a] + found.to_centre[a] - mesh.positions[b] - found.to_centre[b];
        const auto first = static_cast<std::uint32_t>(wires.first_vertex[d]);
        const bool is_ring = glm::length(apart) < 0.25f * std::abs(found.half_width[a]);
        if (is_ring && !rings.are_alike(d, a - first, b - first)) is_bent[found.wire_of[t]] = true;
      }
    }
  }
  for (std::uint32_t w = 0; w < is_bent.size(); ++w) {
    if (is_bent[w]) wires.bent.push_back(w);
  }
  if (!wires.bent.empty()) leave_out(found, mesh.indices, is_bent);
  wires.is_torn = torn(mesh, found.wire_of);
  return wires;
}

std::vector<DrawWires> put_wires(Scene& scene, const WireUnit& unit, const UnitWires& wires,
                                 std::span<const std::uint32_t> ranged, bool as_texcoords) {
  const auto* before = scene.products.find<Wires>();
  const auto texcoords_before = [&](DrawId id) {
    const DrawWires* of = before == nullptr ? nullptr : before->of(id);
    return of == nullptr ? std::nullopt : of->texcoords;
  };
  const FoundWires& found = wires.found;
  std::vector<DrawWires> made;
  std::map<const VertexStreams*, std::shared_ptr<const VertexStreams>> with_wires;
  std::map<const VertexStreams*, std::vector<CopiedVertex>> copies;
  for (std::size_t d = 0; d < unit.draws.size(); ++d) {
    add_copies(wires, d, copies[scene.draws[unit.draws[d]].full().vertices.get()]);
  }
  for (std::size_t d = 0; d < unit.draws.size(); ++d) {
    DrawWires of{.draw = unit.draws[d]};
    std::map<std::uint32_t, std::vector<std::uint32_t>> by_wire;
    std::vector<std::uint32_t> order, left;
    for (std::size_t t = wires.first_triangle[d]; t < wires.first_triangle[d + 1]; ++t) {
      const auto number = static_cast<std::uint32_t>(t - wires.first_triangle[d]);
      if (found.wire_of[t] != FoundWires::none) {
        by_wire[found.wire_of[t]].push_back(number);
      } else {
        (number < ranged[d] && wires.is_torn[t] ? left : order).push_back(number);
      }
    }
    order.insert(order.end(), left.begin(), left.end());
    if (by_wire.empty() && left.empty()) continue;
    of.first_triangle = static_cast<std::uint32_t>(order.size());
    for (const auto& [wire, triangles] : by_wire) {
      const FoundWire& is = found.wires[wire];
      of.wires.push_back({static_cast<std::uint32_t>(triangles.size()), is.kind, static_cast<float>(is.length),
                          static_cast<float>(is.radius), is.closed});
      order.insert(order.end(), triangles.begin(), triangles.end());
    }
    Draw& draw = scene.draws[of.draw];
    if (!by_wire.empty()) {
      const std::shared_ptr<const VertexStreams> old = draw.full().vertices;
      auto& now = with_wires[old.get()];
      const auto plain = without_wire_streams(*old, texcoords_before(of.draw));
      if (as_texcoords) of.texcoords = first_free_texcoord(*plain);
      if (!now) now = with_wire_streams(*plain, found, wires.first_vertex[d], copies[old.get()], of.texcoords);
      take_copies(draw, old->count, wires, d, copies[old.get()]);
    }
    draw = with_triangle_order(draw, order);
    made.push_back(std::move(of));
  }
  // All who share the vertices keep sharing them.
  for (const DrawId id : unit.draws) {
    for (Level& level : scene.draws[id].levels) {
      const auto now = with_wires.find(level.vertices.get());
      if (now != with_wires.end()) level.vertices = now->second;
    }
  }
  return made;
}

}  // namespace foredraw::processors::wire_radius
