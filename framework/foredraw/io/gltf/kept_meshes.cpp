// A mesh drawn by another node is no longer where an extension or a further scene looks for it, and what was hidden,
// moved or left out with its node would be no more. So these nodes keep theirs.
#include <foredraw/io/gltf/private/kept_meshes.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

/// Extensions of a node that say nothing of its mesh, nor of where and whether it is drawn, nor of what is below.
bool leaves_mesh_alone(std::string_view name) {
  return name == mesh_gpu_instancing || name.starts_with("KHR_lights_") || name.starts_with("KHR_xmp");
}

template <class P>
bool any_extension(const Json& holder, P&& is_wanted) {
  const auto extensions = holder.find("extensions");
  if (extensions == holder.end() || !extensions->is_object()) return false;
  for (const auto& [name, value] : extensions->items()) {
    if (is_wanted(name)) return true;
  }
  return false;
}

/// Whether an animation's target, which an extension names, may be a node.
bool may_aim_at_nodes(const Json& target) {
  const Json* pointer = extension_of(target, "KHR_animation_pointer");
  if (pointer == nullptr) return any_extension(target, [](const std::string&) { return true; });
  const auto path = pointer->is_object() ? pointer->find("pointer") : pointer->end();
  return path == pointer->end() || !path->is_string() || path->get<std::string>().starts_with("/nodes");
}

/// Whether something may speak of any node: by its number, or by moving it.
bool may_mean_any_node(const Document& document) {
  const Json& json = document.json;
  const auto is_unknown = [&](const std::string& name) { return !document.knows_extension(name); };
  if (any_extension(json, is_unknown)) return true;
  if (const auto scenes = json.find("scenes"); scenes != json.end()) {
    if (std::ranges::any_of(*scenes, [&](const Json& scene) { return any_extension(scene, is_unknown); })) return true;
  }
  const auto animations = json.find("animations");
  return animations != json.end() && std::ranges::any_of(*animations, [](const Json& animation) {
           return std::ranges::any_of(animation["channels"],
                                      [](const Json& channel) { return may_aim_at_nodes(channel["target"]); });
         });
}

/// A node and all below it. What is marked is marked with all below it.
void mark(NodeId root, const std::vector<Node>& nodes, std::vector<char>& marks) {
  std::vector<NodeId> open{root};
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    if (marks[node] != 0) continue;
    marks[node] = 1;
    open.insert(open.end(), nodes[node].children.begin(), nodes[node].children.end());
  }
}

}  // namespace

void find_kept_meshes(Scene& scene, const Document& document) {
  const Json& json = document.json;
  std::vector<Node>& nodes = scene.nodes;
  std::vector<char> kept(nodes.size(), may_mean_any_node(document));
  std::vector<char> is_root(nodes.size(), 0);
  std::vector<char> has_parent(nodes.size(), 0);
  for (NodeId i = 0; i < nodes.size(); ++i) {
    const bool is_spoken_of = any_extension(json["nodes"][i], [](auto& name) { return !leaves_mesh_alone(name); });
    if (is_spoken_of) mark(i, nodes, kept);
    for (const NodeId child : nodes[i].children) has_parent[child] = 1;
  }
  const Json none = Json::array();
  const Json& scenes = json.contains("scenes") ? json["scenes"] : none;
  const std::size_t first_shown = json.contains("scene") ? json["scene"].get<std::size_t>() : 0;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    if (!scenes[s].contains("nodes")) continue;
    for (const Json& number : scenes[s]["nodes"]) {
      const auto root = number.get<NodeId>();
      // Twice in a scene, or without its parent: viewers make of it what they like.
      if (s != first_shown || has_parent[root] != 0 || is_root[root] != 0) mark(root, nodes, kept);
      is_root[root] = 1;
    }
  }
  // Without scenes, what is added would be in the only one.
  for (NodeId i = 0; i < nodes.size(); ++i) nodes[i].keeps_mesh = kept[i] != 0 || !nodes[i].is_shown || scenes.empty();
}

}  // namespace foredraw::gltf
