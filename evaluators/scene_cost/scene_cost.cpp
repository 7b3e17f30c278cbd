#include "scene_cost.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/instances/merged_instances.h>
#include <foredraw/viewing/order_lookup.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <set>
#include <tuple>

namespace foredraw {

namespace {

constexpr std::uint64_t bytes_of_a_placement = 12 * sizeof(float);

bool is_mirrored(const glm::mat4& matrix) { return glm::determinant(glm::dmat3(matrix)) < 0; }

/// A node's drawing of a mesh.
struct PlacedMesh {
  MeshId mesh = 0;
  NodeId id = 0;
  const Node* node = nullptr;    ///< none: the scene has no nodes
  std::vector<bool> mirrored{};  ///< [instance] whether it is turned inside out
};

std::vector<PlacedMesh> placed_meshes(const Scene& scene) {
  std::vector<PlacedMesh> placed;
  if (scene.nodes.empty()) {
    for (MeshId mesh = 0; mesh < scene.meshes.size(); ++mesh) placed.push_back({mesh, 0, nullptr, {false}});
    return placed;
  }
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.mesh || !node.is_shown) continue;
    const bool node_is_mirrored = !node.skin && is_mirrored(worlds[i]);  // joints alone place what has a skin
    PlacedMesh mesh{*node.mesh, i, &node};
    if (node.instances.empty()) mesh.mirrored.push_back(node_is_mirrored);
    for (const Transform& instance : node.instances.view()) {
      mesh.mirrored.push_back(node_is_mirrored != is_mirrored(instance.matrix()));
    }
    placed.push_back(std::move(mesh));
  }
  return placed;
}

/// How often a draw call draws a primitive.
struct Times {
  std::uint64_t upright = 0;   ///< as it winds,
  std::uint64_t mirrored = 0;  ///< and turned inside out

  std::uint64_t all() const { return upright + mirrored; }
};

/// Without those that merged draws show.
Times times_of(const PlacedMesh& placed, std::uint32_t primitive, std::span<const MergedPlace> merged) {
  Times times;
  for (std::uint32_t i = 0; i < placed.mirrored.size(); ++i) {
    if (std::ranges::binary_search(merged, MergedPlace{placed.id, primitive, i})) continue;
    ++(placed.mirrored[i] ? times.mirrored : times.upright);
  }
  return times;
}

/// What drawing a primitive once costs.
struct DrawnOnce {
  std::uint64_t indices = 0;  ///< none: nothing is drawn
  double shaded = 0;
  Stamp content;  ///< of all that two primitives must have in common to be instances of one
  bool stays_by_itself = false;
};

DrawnOnce drawn_once(const Scene& scene, DrawId id, std::uint32_t cache_size) {
  const Draw& draw = scene.draws[id];
  const Level& level = draw.full();
  DrawnOnce once;
  once.indices = level.orders[0].indices.size();
  if (once.indices == 0) return once;
  for (const ServedOrder& order : served_orders(scene, id)) {
    once.shaded += order.share * FifoCache(level.vertices->count, cache_size).misses(order.indices());
  }
  const std::uint32_t state[] = {static_cast<std::uint32_t>(draw.topology), draw.material.value_or(~MaterialId{0})};
  const Stamp parts[] = {level.vertices->stamp(), level.orders[0].indices.stamp(),
                         content_hash(std::span<const std::uint32_t>(state))};
  once.content = combine(parts);
  const Material* material = scene.material_of(draw);
  once.stays_by_itself =
      !level.vertices->morph_targets.empty() || (material != nullptr && material->alpha_mode == AlphaMode::blend);
  return once;
}

class Sum {
 public:
  explicit Sum(const Scene& scene) : scene_(scene) {
    // The vertices of a mesh that is merged are a part of the merged ones, whoever else draws from them.
    for (const MergedInstances& merged : merged_sets(scene)) {
      for (const MergedMesh& mesh : merged.meshes) {
        for (const VertexStream& stream : scene.draws[mesh.draw].full().vertices->base) {
          vertex_streams_.insert(stream.bytes.view().data());
        }
      }
    }
    for (const MergedInstances& merged : merged_sets(scene)) {
      for (const VertexStream& stream : merged.vertices->base) vertex_streams_.erase(stream.bytes.view().data());
    }
  }

  /// One draw call that draws a primitive as often as its node places it.
  void add_call(DrawId id, const DrawnOnce& once, const PlacedMesh& placed, const Times& placings) {
    const Draw& draw = scene_.draws[id];
    const std::uint64_t times = placings.all();
    cost_.draws += 1;
    cost_.instances += times;
    cost_.indices += once.indices * times;
    cost_.shaded += once.shaded * static_cast<double>(times);
    if (draw.topology == Topology::triangles) {
      cost_.triangles += once.indices / 3 * times;
      cost_.triangles_shaded += once.shaded * static_cast<double>(times);
    }
    if (once.stays_by_itself || (placed.node != nullptr && placed.node->skin)) {
      cost_.draws_if_instanced += 1;
    } else {
      if (placings.upright > 0) instanced_.emplace(once.content, false);
      if (placings.mirrored > 0) instanced_.emplace(once.content, true);
    }
    if (referred_.insert(id).second) refer_to(id);
  }

  /// Calls that fetch their vertices themselves, one call of the vertex shader for each index entry.
  void add_merged(const MergedInstances& merged) {
    for (const MergedDraw& draw : merged.draws) {
      const std::uint64_t entries = std::uint64_t{draw.slot_count} * draw.frequency;
      cost_.draws += 1;
      cost_.draws_if_instanced += 1;
      cost_.indices += entries;
      cost_.shaded += static_cast<double>(entries);
      cost_.triangles += entries / 3;
      cost_.triangles_shaded += static_cast<double>(entries);
    }
    cost_.instances += merged.places.size();
    add_placements(merged.places.size());
    cost_.instance_bytes += merged.slots.view().size_bytes() + merged.materials.view().size_bytes();
    refer_to(*merged.vertices);
    refer_to(merged.indices.view(), 4);
  }

  /// What tells a draw call where a mesh is.
  void add_placements(std::uint64_t times) { cost_.instance_bytes += bytes_of_a_placement * times; }

  SceneCost cost() const {
    SceneCost cost = cost_;
    cost.draws_if_instanced += instanced_.size();
    return cost;
  }

 private:
  void refer_to(DrawId id) {
    const VertexStreams& vertices = *scene_.draws[id].full().vertices;
    refer_to(vertices);
    const std::uint64_t width = vertices.count < 65536 ? 2 : 4;
    for (const ServedOrder& order : served_orders(scene_, id)) refer_to(order.indices(), width);
  }

  void refer_to(const VertexStreams& vertices) {
    for (const VertexStream* stream : vertices.all()) {
      if (vertex_streams_.insert(stream->bytes.view().data()).second) cost_.vertex_bytes += stream->bytes.size();
    }
  }

  void refer_to(std::span<const std::uint32_t> indices, std::uint64_t width) {
    if (index_streams_.emplace(indices.data(), width).second) cost_.index_bytes += width * indices.size();
  }

  const Scene& scene_;
  SceneCost cost_;
  std::set<std::pair<Stamp, bool>> instanced_;  ///< and whether mirrored
  std::set<DrawId> referred_;
  std::set<const std::byte*> vertex_streams_;
  std::set<std::pair<const std::uint32_t*, std::uint64_t>> index_streams_;
};

}  // namespace

SceneCost scene_cost(const Scene& scene, const SceneCostOptions& options, const Executor& executor) {
  std::vector<DrawnOnce> once(scene.draws.size());
  executor.for_each(once.size(), [&](std::size_t id) {
    once[id] = drawn_once(scene, static_cast<DrawId>(id), static_cast<std::uint32_t>(options.cache_size));
  });
  Sum sum(scene);
  const std::vector<MergedPlace> merged = merged_places(scene);
  for (const PlacedMesh& placed : placed_meshes(scene)) {
    std::uint64_t seen = 0;
    const std::vector<DrawId>& draws = scene.meshes[placed.mesh].draws;
    for (std::uint32_t primitive = 0; primitive < draws.size(); ++primitive) {
      const DrawnOnce& drawn = once[draws[primitive]];
      const Times times = times_of(placed, primitive, merged);
      if (drawn.indices == 0 || times.all() == 0) continue;
      sum.add_call(draws[primitive], drawn, placed, times);
      seen = std::max(seen, times.all());
    }
    sum.add_placements(seen);
  }
  for (const MergedInstances& set : merged_sets(scene)) sum.add_merged(set);
  return sum.cost();
}

SceneCost scene_cost(const Scene& scene, const SceneCostOptions& options) {
  return scene_cost(scene, options, Executor(1));
}

}  // namespace foredraw
