#include "mergeable.h"

#include "packing.h"

#include <foredraw/analysis/moved_nodes.h>
#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/base/counted.h>
#include <foredraw/geometry/finite.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace foredraw::processors::merge_instances {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
constexpr float beyond_all = std::numeric_limits<float>::infinity();

/// "3.25": two digits, the same everywhere.
std::string two_digits(double value) {
  const auto hundredths = static_cast<std::uint64_t>(std::max(0.0, value) * 100 + 0.5);
  const std::string rest = std::to_string(hundredths % 100);
  return std::to_string(hundredths / 100) + "." + (rest.size() < 2 ? "0" : "") + rest;
}

std::string why_not_merged(const Scene& scene, const Draw& draw, const MergeableOptions& options) {
  if (draw.topology != Topology::triangles) return "it draws no triangles";
  const bool is_skinned = draw.traits.has(traits::skinned);
  if (is_skinned && !options.skinned) return "it is skinned";
  if (draw.traits.has(traits::morphed) || !draw.levels[0].vertices->morph_targets.empty())
    return "it has morph targets";
  if (draw.traits.has(traits::animated) && !is_skinned) return "an animation changes its shape";
  const Material* material = scene.material_of(draw);
  if (draw.traits.has(traits::blended) || (material != nullptr && material->alpha_mode == AlphaMode::blend)) {
    return "it is blended, so the order of draws is visible";
  }
  if (draw.traits.has(traits::extended)) {
    return "an extension refers to its triangles or vertices";
  }
  if (draw.material && material == nullptr) return "its material is missing";
  if (draw.levels.size() != 1) return "it has several levels of detail";
  if (draw.levels[0].orders.size() != 1) return "it has several orders to choose from";
  if (draw.levels[0].vertices->find("POSITION") == nullptr) return "it has no positions";
  if (draw.levels[0].orders[0].indices.size() < 3) return "it has no triangles";
  return "";
}

/// What of a draw does not depend on where it is placed.
struct DrawFacts {
  Box<glm::vec3> box;  ///< of the positions that are drawn; empty where one is not finite
  std::uint64_t shaded = 0;
};

DrawFacts facts_of(const Draw& draw) {
  const std::span<const std::uint32_t> indices = draw.levels[0].orders[0].indices.view();
  const VertexStream& positions = *draw.levels[0].vertices->find("POSITION");
  DrawFacts facts;
  facts.shaded = count_fifo(indices, draw.levels[0].vertices->count, 16).misses;
  const std::vector<glm::vec3> decoded = decode_vec3(positions);
  std::vector<char> is_added(decoded.size(), 0);
  for (const std::uint32_t index : indices) {
    if (is_added[index] != 0) continue;
    is_added[index] = 1;
    const glm::vec3& point = decoded[index];
    if (!is_finite(point)) return {{}, facts.shaded};
    facts.box.add(point);
  }
  return facts;
}

/// The upright box around a box that a transform turns: its middle goes along, and each half side adds up.
Box<glm::vec3> box_in_world(const Box<glm::vec3>& box, const glm::mat4& world) {
  Box<glm::vec3> result;
  for (int row = 0; row < 3; ++row) {
    double middle = world[3][row], half = 0;
    for (int column = 0; column < 3; ++column) {
      const double element = world[column][row];
      middle += element * (double{box.min[column]} + double{box.max[column]}) / 2;
      half += std::abs(element) * (double{box.max[column]} - double{box.min[column]}) / 2;
    }
    // Outwards to floats: nothing sticks out.
    result.min[row] = static_cast<float>(middle - half);
    if (double{result.min[row]} > middle - half) result.min[row] = std::nextafter(result.min[row], -beyond_all);
    result.max[row] = static_cast<float>(middle + half);
    if (double{result.max[row]} < middle + half) result.max[row] = std::nextafter(result.max[row], beyond_all);
  }
  return result;
}

/// Why the set's draws stay as they are; empty: they should be merged.
std::string why_not_worth_it(const MergeableSet& set, const MergeableOptions& options) {
  const std::uint64_t placed = set.placements.size();
  if (placed == 0) return "nothing is placed";
  if (set.meshes.size() == 1) {
    return "1 mesh, " + counted(placed, "instance") +
           (placed == 1 ? ": one draw already" : ": instancing does the same");
  }
  if (placed < options.least_placements) {
    return counted(placed, "placement") + "; at least " + std::to_string(options.least_placements) + " are needed";
  }
  return "";
}

/// A mesh for which the cache of an index buffer saves more than a draw costs.
std::string why_vertex_bound(const MergeableMesh& mesh, const MergeableOptions& options) {
  const double extra = static_cast<double>(mesh.indices) - static_cast<double>(mesh.shaded);
  if (extra <= options.draw_cost) return "";
  return "vertex-bound: merged, it would shade 3 vertices a triangle instead of " + two_digits(mesh.acmr()) + ", " +
         std::to_string(static_cast<std::uint64_t>(extra)) + " more for each draw saved; draw-cost allows " +
         std::to_string(static_cast<std::uint64_t>(options.draw_cost));
}

/// What two materials must have in common to be drawn together. Those of which nothing more is known, their number.
Stamp shared_material(const Scene& scene, const Draw& draw, SharedMaterials materials) {
  const Material* material = scene.material_of(draw);
  if (material != nullptr) {
    if (const auto& known = materials == SharedMaterials::kind ? material->kind : material->look) return *known;
  }
  return {0, draw.material ? *draw.material : std::uint64_t{none}};
}

/// Sets by material and layout, in the sequence of their first draws.
class Sorting {
 public:
  Sorting(const Scene& scene, SharedMaterials materials) : scene_(scene), materials_(materials) {}

  /// The set's number.
  std::size_t set_of(const Draw& draw, std::vector<MergeableSet>& sets) {
    const auto [it, is_new] = places_.try_emplace(
        {shared_material(scene_, draw, materials_), draw.levels[0].vertices->layout_stamp()}, sets.size());
    if (is_new) sets.emplace_back().material = draw.material;
    return it->second;
  }

 private:
  const Scene& scene_;
  const SharedMaterials materials_;
  std::map<std::pair<Stamp, Stamp>, std::size_t> places_;
};

/// Where a draw's triangles are in all poses.
Box<glm::vec3> box_of_poses(const Scene& scene, const SubjectPart& part, std::span<const PosedNodes> poses) {
  Box<glm::vec3> box;
  for (const PosedNodes& nodes : poses) {
    const std::vector<glm::vec3> positions = posed_positions(scene, part, nodes);
    for (const std::uint32_t index : scene.draws[part.draw].levels[0].orders[0].indices.view())
      box.add(positions[index]);
  }
  return box;
}

/// Why a node's drawing of a mesh stays as it is; empty: it can be merged.
std::string why_not_merged(const Node& node, bool is_moved, const glm::mat4& world) {
  if (!node.is_shown) return "it is not shown: hidden, or not in the scene that the file shows";
  if (node.keeps_mesh) return "an extension or another scene may refer to its node";
  if (node.skin && !node.instances.empty()) return "it is skinned and has instances";
  if (node.skin) return glm::determinant(glm::dmat3(world)) < 0 ? "its node mirrors what its joints place" : "";
  if (is_moved) return "an animation moves it, or its parent is a joint";
  const Placing placing = placing_of(world);
  return placing == Placing::plain || placing == Placing::mirrored ? "" : std::string(to_text(placing));
}

}  // namespace

MergeableScene mergeable_scene(const Scene& scene, std::span<const DrawId> draws, const MergeableOptions& options,
                               const Executor& executor) {
  MergeableScene result;
  std::vector<char> may(scene.draws.size(), 0);
  std::vector<DrawId> candidates;
  for (const DrawId id : draws) {
    std::string why = why_not_merged(scene, scene.draws[id], options);
    if (why.empty()) {
      candidates.push_back(id);
    } else {
      result.left_alone.push_back({id, std::nullopt, std::move(why)});
    }
  }
  std::vector<DrawFacts> facts(candidates.size());
  executor.for_each(candidates.size(), [&](std::size_t i) { facts[i] = facts_of(scene.draws[candidates[i]]); });

  struct PlaceInSet {
    std::size_t set = 0;
    std::uint32_t mesh = 0;
    Box<glm::vec3> box;
  };
  std::vector<PlaceInSet> places(scene.draws.size());
  Sorting sorting(scene, options.materials);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Draw& draw = scene.draws[candidates[i]];
    MergeableMesh mesh{candidates[i], draw.levels[0].orders[0].indices.size(), 0, facts[i].shaded};
    if (facts[i].box.is_empty()) {
      result.left_alone.push_back({candidates[i], std::nullopt, "it has positions that are not finite"});
      continue;
    }
    if (const std::string why = why_vertex_bound(mesh, options); !why.empty()) {
      result.left_alone.push_back({candidates[i], std::nullopt, why});
      continue;
    }
    const std::size_t set = sorting.set_of(draw, result.sets);
    std::vector<MergeableMesh>& meshes = result.sets[set].meshes;
    places[candidates[i]] = {set, static_cast<std::uint32_t>(meshes.size()), facts[i].box};
    meshes.push_back(mesh);
    may[candidates[i]] = 1;
  }

  std::vector<char> is_placed(scene.draws.size(), 0);
  const std::vector<bool> moved = moved_nodes(scene);
  const std::vector<glm::mat4> world = world_transforms(scene);
  std::vector<PosedNodes> poses;
  for (const Pose& pose : options.poses.poses) {
    if (options.skinned) poses.push_back(posed_nodes(scene, pose));
  }
  const auto place = [&](NodeId n, std::uint32_t instance, const glm::mat4& to_world) {
    const Node& node = scene.nodes[n];
    const std::vector<DrawId>& shown = scene.meshes[*node.mesh].draws;
    const std::string why_node = why_not_merged(node, moved[n], to_world);
    for (std::uint32_t primitive = 0; primitive < shown.size(); ++primitive) {
      const DrawId id = shown[primitive];
      if (may[id] == 0) continue;
      is_placed[id] = 1;
      const PlaceInSet& in = places[id];
      MergeablePlacement placement{in.mesh, {n, primitive, instance}, to_world, {}};
      std::string why = why_node;
      const bool is_skinned = scene.draws[id].traits.has(traits::skinned);
      if (why.empty() && node.skin && !is_skinned) why = "its node has a skin, but it has no joints";
      if (why.empty() && !node.skin && is_skinned) why = "it has joints, but its node has no skin";
      if (why.empty() && is_skinned) {
        placement.world = glm::mat4(1);
        placement.box = box_of_poses(scene, {id, n}, poses);
      } else if (why.empty()) {
        placement.box = box_in_world(in.box, to_world);
      }
      if (why.empty()) {
        if (!is_finite(placement.box.min) || !is_finite(placement.box.max))
          why = "in the world it is too large for 32-bit floats";
      }
      if (!why.empty()) {
        result.left_alone.push_back({id, n, std::move(why)});
        continue;
      }
      MergeableSet& set = result.sets[in.set];
      set.placements.push_back(placement);
      ++set.meshes[in.mesh].placed;
    }
  };
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    if (node.instances.empty()) place(n, 0, world[n]);
    std::uint32_t instance = 0;
    for (const Transform& transform : node.instances.view()) place(n, instance++, world[n] * transform.matrix());
  }
  // Meshes that are not placed have no part in it.
  for (const DrawId id : candidates) {
    if (may[id] != 0 && is_placed[id] == 0) result.left_alone.push_back({id, std::nullopt, "no node places it"});
  }
  for (MergeableSet& set : result.sets) {
    std::vector<std::uint32_t> number(set.meshes.size(), none);
    std::vector<MergeableMesh> placed;
    for (std::size_t m = 0; m < set.meshes.size(); ++m) {
      if (set.meshes[m].placed == 0) continue;
      number[m] = static_cast<std::uint32_t>(placed.size());
      placed.push_back(set.meshes[m]);
    }
    set.meshes = std::move(placed);
    for (MergeablePlacement& placement : set.placements) placement.mesh = number[placement.mesh];
    set.why_not = why_not_worth_it(set, options);
  }
  return result;
}

}  // namespace foredraw::processors::merge_instances
