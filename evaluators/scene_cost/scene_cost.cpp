#include "scene_cost.h"

#include <foredraw/analysis/order_lookup.h>
#include <foredraw/analysis/vertex_cache.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <set>
#include <tuple>

namespace foredraw {

namespace {

constexpr std::uint64_t bytes_of_a_placement = 12 * sizeof(float);

bool is_mirrored(const glm::mat4& matrix) { return glm::determinant(glm::dmat3(matrix)) < 0; }

/// A mesh as one node shows it.
struct PlacedMesh {
  MeshId mesh = 0;
  const Node* node = nullptr;  ///< none: the scene has no nodes
  std::uint64_t upright = 0;   ///< how often the mesh is drawn as it winds,
  std::uint64_t mirrored = 0;  ///< and how often turned inside out

  std::uint64_t times() const { return upright + mirrored; }
};

std::vector<PlacedMesh> placed_meshes(const Scene& scene) {
  std::vector<PlacedMesh> placed;
  if (scene.nodes.empty()) {
    for (MeshId mesh = 0; mesh < scene.meshes.size(); ++mesh) placed.push_back({mesh, nullptr, 1, 0});
    return placed;
  }
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.mesh) continue;
    const bool node_is_mirrored = !node.skin && is_mirrored(worlds[i]);  // joints alone place what has a skin
    PlacedMesh mesh{*node.mesh, &node, 0, 0};
    const auto add = [&](bool mirrored) { ++(mirrored ? mesh.mirrored : mesh.upright); };
    if (node.instances.empty()) add(node_is_mirrored);
    for (const Transform& instance : node.instances.view()) add(node_is_mirrored != is_mirrored(instance.matrix()));
    placed.push_back(mesh);
  }
  return placed;
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
  const Level& level = draw.levels[0];
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
  explicit Sum(const Scene& scene) : scene_(scene) {}

  /// One draw call that draws a primitive as often as its node places it.
  void add_call(DrawId id, const DrawnOnce& once, const PlacedMesh& placed) {
    const Draw& draw = scene_.draws[id];
    const std::uint64_t times = placed.times();
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
      if (placed.upright > 0) instanced_.emplace(once.content, false);
      if (placed.mirrored > 0) instanced_.emplace(once.content, true);
    }
    if (referred_.insert(id).second) refer_to(id);
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
    const VertexStreams& vertices = *scene_.draws[id].levels[0].vertices;
    for (const VertexStream* stream : vertices.all()) {
      if (vertex_streams_.insert(stream->bytes.view().data()).second) cost_.vertex_bytes += stream->bytes.size();
    }
    const std::uint64_t width = vertices.count < 65536 ? 2 : 4;
    for (const ServedOrder& order : served_orders(scene_, id)) {
      const auto indices = order.indices();
      if (index_streams_.emplace(indices.data(), width).second) cost_.index_bytes += width * indices.size();
    }
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
  for (const PlacedMesh& placed : placed_meshes(scene)) {
    bool is_seen = false;
    for (const DrawId id : scene.meshes[placed.mesh].draws) {
      if (once[id].indices == 0) continue;
      sum.add_call(id, once[id], placed);
      is_seen = true;
    }
    if (is_seen) sum.add_placements(placed.times());
  }
  return sum.cost();
}

SceneCost scene_cost(const Scene& scene, const SceneCostOptions& options) {
  return scene_cost(scene, options, Executor(1));
}

}  // namespace foredraw
