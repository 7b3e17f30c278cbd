#include <foredraw/scene/walk.h>

namespace foredraw {

std::vector<NodeId> walk(const Scene& scene) {
  std::vector<char> has_parent(scene.nodes.size(), 0);
  for (const Node& node : scene.nodes) {
    for (const NodeId child : node.children) has_parent[child] = 1;
  }
  std::vector<NodeId> walked;
  std::vector<NodeId> open;  // the next one last
  for (NodeId root = 0; root < scene.nodes.size(); ++root) {
    if (has_parent[root] == 0) open.push_back(root);
    while (!open.empty()) {
      walked.push_back(open.back());
      const std::vector<NodeId>& children = scene.nodes[open.back()].children;
      open.pop_back();
      open.insert(open.end(), children.rbegin(), children.rend());
    }
  }
  return walked;
}

}  // namespace foredraw
