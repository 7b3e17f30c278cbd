// Which nodes are seen: a file may hold several scenes, nodes of none, and nodes that say that they are hidden.
#include <foredraw/io/gltf/private/member.h>
#include <foredraw/io/gltf/private/source.h>
#include <foredraw/scene/walk.h>

namespace foredraw::gltf {

namespace {

/// Those that the scene to be shown names; nothing where the file has no scenes.
std::optional<std::vector<NodeId>> shown_roots(const Json& json) {
  const auto scenes = json.find("scenes");
  if (scenes == json.end() || scenes->empty()) return std::nullopt;
  const Json& shown = (*scenes)[json.value("scene", std::size_t{0})];
  const auto nodes = shown.find("nodes");
  return nodes == shown.end() ? std::vector<NodeId>() : nodes->get<std::vector<NodeId>>();
}

/// With all that is below it.
bool is_hidden(const Json& node) {
  const Json* visibility = extension_of(node, "KHR_node_visibility");
  const Json* visible = visibility == nullptr ? nullptr : member(*visibility, "visible");
  return visible != nullptr && *visible == false;
}

}  // namespace

void find_shown_nodes(Scene& scene, const Document& document) {
  for (Node& node : scene.nodes) node.is_shown = false;
  const auto roots = shown_roots(document.json);
  if (roots) scene.roots = *roots;
  std::vector<NodeId> open = roots ? *roots : roots_of(scene);
  while (!open.empty()) {
    const NodeId n = open.back();
    open.pop_back();
    Node& node = scene.nodes[n];
    if (node.is_shown || is_hidden(document.json["nodes"][n])) continue;
    node.is_shown = true;
    open.insert(open.end(), node.children.begin(), node.children.end());
  }
}

}  // namespace foredraw::gltf
