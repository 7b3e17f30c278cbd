#include "bodies.h"

#include <algorithm>
#include <string>

namespace foredraw::processors::hidden {

namespace {

/// [vertex] the one body that its joints are of, or that of the node where none has a weight.
std::vector<Body> bodies_of_vertices(const Scene& scene, const Node& node, Body of_node, const VertexStreams& vertices,
                                     const std::vector<Body>& carriers) {
  std::vector<Body> bodies(vertices.count, of_node);
  if (!node.skin) return bodies;
  const Skin& skin = scene.skins[*node.skin];
  std::vector<bool> has_weight(vertices.count, false);
  for (int n = 0;; ++n) {
    const VertexStream* joints = vertices.find("JOINTS_" + std::to_string(n));
    const VertexStream* weights = vertices.find("WEIGHTS_" + std::to_string(n));
    if (joints == nullptr || weights == nullptr) return bodies;
    const std::size_t components = std::min(joints->format.components, weights->format.components);
    for (std::size_t v = 0; v < vertices.count; ++v) {
      for (std::size_t c = 0; c < components; ++c) {
        const float joint = decode_component(*joints, v, c);
        const bool is_joint = joint >= 0 && joint < static_cast<float>(skin.joints.size());
        if (decode_component(*weights, v, c) == 0 || !is_joint) continue;
        const Body body = carriers[skin.joints[static_cast<std::size_t>(joint)]];
        bodies[v] = !has_weight[v] || bodies[v] == body ? body : bends;
        has_weight[v] = true;
      }
    }
  }
}

}  // namespace

std::vector<Body> carriers(const Scene& scene) {
  std::vector<bool> carries(scene.nodes.size(), false);
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.path != AnimatedPath::weights && channel.node < carries.size()) carries[channel.node] = true;
    }
  }
  for (const Skin& skin : scene.skins) {
    for (const NodeId joint : skin.joints) carries[joint] = true;
  }
  std::vector<bool> has_parent(scene.nodes.size(), false);
  for (const Node& node : scene.nodes) {
    for (const NodeId child : node.children) has_parent[child] = true;
  }
  std::vector<Body> result(scene.nodes.size(), stands_still);
  std::vector<NodeId> open;
  for (NodeId node = 0; node < scene.nodes.size(); ++node) {
    if (has_parent[node]) continue;
    if (carries[node]) result[node] = node;
    open.push_back(node);
  }
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    for (const NodeId child : scene.nodes[node].children) {
      result[child] = carries[child] ? child : result[node];
      open.push_back(child);
    }
  }
  return result;
}

std::vector<Body> bodies_of(const Scene& scene, const SubjectPart& part, const std::vector<Body>& carriers) {
  const Level& level = scene.draws[part.draw].full();
  const std::vector<Body> of_vertices =
      bodies_of_vertices(scene, scene.nodes[*part.node], carriers[*part.node], *level.vertices, carriers);
  const auto indices = level.stream().indices.view();
  std::vector<Body> bodies;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Body a = of_vertices[indices[i]], b = of_vertices[indices[i + 1]], c = of_vertices[indices[i + 2]];
    bodies.push_back(a == b && b == c ? a : bends);
  }
  return bodies;
}

}  // namespace foredraw::processors::hidden
