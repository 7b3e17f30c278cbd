#include <foredraw/analysis/moved_nodes.h>

namespace foredraw {

std::vector<bool> moved_nodes(const Scene& scene) {
  std::vector<NodeId> open;
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.path != AnimatedPath::weights) open.push_back(channel.node);
    }
  }
  for (const Skin& skin : scene.skins) open.insert(open.end(), skin.joints.begin(), skin.joints.end());
  std::vector<bool> moved(scene.nodes.size(), false);
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    if (node >= moved.size() || moved[node]) continue;
    moved[node] = true;
    open.insert(open.end(), scene.nodes[node].children.begin(), scene.nodes[node].children.end());
  }
  return moved;
}

}  // namespace foredraw
