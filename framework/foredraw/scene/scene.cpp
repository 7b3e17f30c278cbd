#include <foredraw/scene/scene.h>

#include <glm/gtc/matrix_transform.hpp>

namespace foredraw {

glm::mat4 Transform::matrix() const {
  return glm::translate(glm::mat4(1), translation) * glm::mat4_cast(rotation) * glm::scale(glm::mat4(1), scale);
}

glm::mat4 Node::local() const { return matrix ? *matrix : transform.matrix(); }

std::vector<glm::mat4> world_transforms(const Scene& scene, std::span<const glm::mat4> locals) {
  std::vector<char> has_parent(scene.nodes.size(), 0);
  for (const Node& node : scene.nodes) {
    for (NodeId child : node.children) has_parent[child] = 1;
  }
  std::vector<glm::mat4> world(scene.nodes.size(), glm::mat4(1));
  std::vector<NodeId> open;
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    if (has_parent[i]) continue;
    world[i] = locals[i];
    open.push_back(i);
  }
  while (!open.empty()) {
    const NodeId parent = open.back();
    open.pop_back();
    for (NodeId child : scene.nodes[parent].children) {
      world[child] = world[parent] * locals[child];
      open.push_back(child);
    }
  }
  return world;
}

std::vector<glm::mat4> world_transforms(const Scene& scene) {
  std::vector<glm::mat4> locals;
  for (const Node& node : scene.nodes) locals.push_back(node.local());
  return world_transforms(scene, locals);
}

}  // namespace foredraw
