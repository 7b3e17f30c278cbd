// Which nodes are seen: a file may hold several scenes, and nodes of none.
#include <foredraw/io/private/gltf_source.h>

namespace foredraw::gltf {

void find_shown_nodes(Scene& scene, const Document& document) {
  const auto scenes = document.json.find("scenes");
  if (scenes == document.json.end() || scenes->empty()) return;
  for (Node& node : scene.nodes) node.is_shown = false;
  const Json& shown = (*scenes)[document.json.value("scene", std::size_t{0})];
  std::vector<NodeId> open;
  if (const auto roots = shown.find("nodes"); roots != shown.end()) open = roots->get<std::vector<NodeId>>();
  while (!open.empty()) {
    Node& node = scene.nodes[open.back()];
    open.pop_back();
    if (node.is_shown) continue;
    node.is_shown = true;
    open.insert(open.end(), node.children.begin(), node.children.end());
  }
}

}  // namespace foredraw::gltf
