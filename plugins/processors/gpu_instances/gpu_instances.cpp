#include "gpu_instances.h"

#include "instance_transform.h"

#include <foredraw/analysis/moved_nodes.h>
#include <foredraw/instances/merged_instances.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace foredraw {

namespace {

/// Why a draw can not be drawn many times at once; empty: it can.
std::string_view why_not(const Scene& scene, const Draw& draw) {
  const Material* material = scene.material_of(draw);
  if (draw.traits.has(traits::blended) || (material != nullptr && material->alpha_mode == AlphaMode::blend)) {
    return "they are blended, so the order of draws is visible";
  }
  if (draw.traits.has(traits::skinned)) return "they are skinned";
  if (draw.traits.has(traits::animated)) return "an animation changes their shape";
  if (draw.levels.size() != 1) return "they have several levels of detail";
  if (draw.full().orders.size() != 1) return "they have several orders, of which each node picks its own";
  if (draw.traits.has(traits::morphed) || !draw.full().vertices->morph_targets.empty())
    return "they have morph targets";
  return {};
}

std::string_view why_not(const Scene& scene, const Mesh& mesh, const std::vector<char>& may_change) {
  for (const DrawId id : mesh.draws) {
    if (may_change[id] == 0) return "a primitive of the mesh must stay as it is";
    if (const std::string_view why = why_not(scene, scene.draws[id]); !why.empty()) return why;
  }
  return {};
}

/// What of the nodes is found once for all meshes.
struct NodeFacts {
  explicit NodeFacts(const Scene& scene)
      : moved(moved_nodes(scene)),
        merged(scene.nodes.size(), 0),
        has_parent(scene.nodes.size(), 0),
        world(world_transforms(scene)) {
    for (const MergedPlace& place : merged_places(scene)) merged[place.node] = 1;
    for (const Node& node : scene.nodes) {
      for (const NodeId child : node.children) has_parent[child] = 1;
    }
  }

  std::vector<bool> moved;
  std::vector<char> merged;
  std::vector<char> has_parent;
  std::vector<glm::mat4> world;
};

InstanceTransform placed(const Node& node, NodeId id, const NodeFacts& facts) {
  if (node.skin) return {{}, "they are skinned"};
  if (!node.instances.empty()) return {{}, "they are instanced already"};
  if (!node.weights.empty()) return {{}, "they have morph weights"};
  if (facts.merged[id] != 0) return {{}, "merged draws draw them"};
  if (node.keeps_mesh) return {{}, "an extension or another scene refers to them, or no scene shows them"};
  if (facts.moved[id]) return {{}, "an animation or a joint moves them"};
  return instance_transform(node, facts.has_parent[id] == 0, facts.world[id]);
}

/// The nodes of a mesh, sorted into those that become instances and those that stay.
struct PlacedMesh {
  std::vector<NodeId> nodes;
  std::vector<Transform> transforms;
  std::map<std::string_view, std::uint32_t> left;  ///< [why] how many
};

PlacedMesh placed_mesh(const Scene& scene, const std::vector<NodeId>& shown_by, const NodeFacts& facts) {
  PlacedMesh result;
  for (const NodeId id : shown_by) {
    const InstanceTransform instance = placed(scene.nodes[id], id, facts);
    if (instance.why_not.empty()) {
      result.nodes.push_back(id);
      result.transforms.push_back(instance.transform);
    } else {
      ++result.left[instance.why_not];
    }
  }
  return result;
}

}  // namespace

InstancedNodes gpu_instances(Scene& scene, std::span<const DrawId> draws, const GpuInstancesOptions& options) {
  std::vector<char> may_change(scene.draws.size(), 0);
  for (const DrawId id : draws) may_change[id] = 1;
  std::vector<std::vector<NodeId>> shown_by(scene.meshes.size());
  for (NodeId id = 0; id < scene.nodes.size(); ++id) {
    if (scene.nodes[id].mesh) shown_by[*scene.nodes[id].mesh].push_back(id);
  }

  const NodeFacts facts(scene);
  InstancedNodes result;
  for (MeshId m = 0; m < scene.meshes.size(); ++m) {
    const Mesh& mesh = scene.meshes[m];
    const auto count = static_cast<std::uint32_t>(shown_by[m].size());
    // Whoever gave the draws knows of those that he left out whole.
    const bool is_asked_for = std::ranges::any_of(mesh.draws, [&](DrawId id) { return may_change[id] != 0; });
    if (count < 2 || !is_asked_for) continue;
    if (const std::string_view why = why_not(scene, mesh, may_change); !why.empty()) {
      result.left.push_back({m, count, std::string(why)});
      continue;
    }
    PlacedMesh now = placed_mesh(scene, shown_by[m], facts);
    for (const auto& [why, nodes] : now.left) result.left.push_back({m, nodes, std::string(why)});
    const auto instances = static_cast<std::uint32_t>(now.nodes.size());
    if (instances == 0) continue;
    if (instances < static_cast<std::uint32_t>(options.least)) {
      result.left.push_back(
          {m, instances, "fewer than " + std::to_string(options.least) + " are not replaced (option least)"});
      continue;
    }
    for (const NodeId id : now.nodes) scene.nodes[id].mesh.reset();
    result.meshes.push_back({m, static_cast<NodeId>(scene.nodes.size()), instances});
    Node& node = scene.nodes.emplace_back();
    node.name = mesh.name;
    node.mesh = m;
    node.instances = Shared<Transform>(std::move(now.transforms));
  }
  return result;
}

}  // namespace foredraw
