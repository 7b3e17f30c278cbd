#include <foredraw/scene/walk.h>

namespace foredraw {

std::vector<NodeId> roots_of(const Scene& scene) {
  std::vector<char> is_taken(scene.nodes.size(), 0);  // by a parent, or as a root
  for (const Node& node : scene.nodes) {
    for (const NodeId child : node.children) is_taken[child] = 1;
  }
  std::vector<NodeId> roots;
  const auto take = [&](NodeId node) {
    if (is_taken[node] != 0) return;
    is_taken[node] = 1;
    roots.push_back(node);
  };
  for (const NodeId node : scene.roots) take(node);
  for (NodeId node = 0; node < scene.nodes.size(); ++node) take(node);
  return roots;
}

std::vector<NodeId> walk(const Scene& scene) {
  std::vector<NodeId> walked;
  std::vector<NodeId> open;  // the next one last
  for (const NodeId root : roots_of(scene)) {
    open.push_back(root);
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
