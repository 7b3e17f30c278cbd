// Nodes put back: of those that there were the members that differ, and those that were added.
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/instances.h>
#include <foredraw/scene/walk.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::gltf {

namespace {

std::vector<NodeId> sorted(std::vector<NodeId> nodes) {
  std::ranges::sort(nodes);
  return nodes;
}

/// Those that there were. They may come in another sequence.
std::vector<NodeId> old_ones(std::vector<NodeId> nodes, std::size_t old) {
  std::erase_if(nodes, [&](NodeId node) { return node >= old; });
  return nodes;
}

bool same(const Transform& a, const Transform& b) {
  return a.translation == b.translation && a.rotation == b.rotation && a.scale == b.scale;
}

bool is_finite(const Transform& t) {
  return all_finite({glm::value_ptr(t.translation), 3}) && all_finite({glm::value_ptr(t.rotation), 4}) &&
         all_finite({glm::value_ptr(t.scale), 3});
}

/// What of a node glTF has no words for; empty: it has words for all.
std::string why_not_said(const Node& node) {
  if (node.matrix) {
    const float* m = glm::value_ptr(*node.matrix);
    const bool is_affine = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
    if (!is_affine || !all_finite({m, 16})) return "its matrix is not finite, or its last row is not 0, 0, 0, 1";
  }
  if (!is_finite(node.transform)) return "its transform is not finite";
  if (!all_finite(node.weights)) return "its morph weights are not finite";
  if (!std::ranges::all_of(node.instances.view(), is_finite)) return "its instances are not finite";
  return {};
}

/// Of a mesh that is another one, or none.
std::string why_not_drawn_so(const Node& now, const Node& was) {
  if (now.mesh) return "it was given another mesh";
  if (was.skin || !was.instances.empty()) return "its mesh was removed, and it has a skin or instances";
  if (was.keeps_mesh)
    return "its mesh was removed, but an extension or a further scene refers to it, or no scene shows it";
  return now.weights.empty() ? "" : "its mesh was removed, but not its morph weights";
}

/// What of a change to one of `old` nodes can not be written; empty: all can.
std::string why_not(const Node& now, const Node& was, std::size_t old) {
  if (now.mesh != was.mesh) {
    if (std::string why = why_not_drawn_so(now, was); !why.empty()) return why;
  }
  if (now.skin != was.skin) return "its skin was changed";
  if (now.matrix.has_value() != was.matrix.has_value() || (was.matrix && !same(now.transform, was.transform)))
    return "its matrix was replaced by translation, rotation and scale, or these by a matrix";
  if (now.instances.size() != was.instances.size()) return "its number of instances was changed";
  if (now.children != was.children && sorted(old_ones(now.children, old)) != sorted(was.children))
    return "children that the file has were added to it or taken from it";
  return why_not_said(now);
}

std::string place_of(std::size_t node) { return "nodes[" + std::to_string(node) + ']'; }

/// Why nodes can not hang together so.
std::optional<Refusal> why_no_tree(const std::vector<Node>& nodes) {
  std::vector<char> is_held(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const NodeId child : nodes[i].children) {
      if (child >= nodes.size() || is_held[child]++ != 0)
        return Refusal{place_of(i), "one of its children is not there, or is a child elsewhere, too"};
    }
  }
  return std::nullopt;
}

Json said(const std::string& text) { return text; }
Json said(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }
Json said(const glm::quat& q) { return Json::array({q.x, q.y, q.z, q.w}); }

template <class T>
Json said(const std::vector<T>& values) {
  return values;
}

/// The member where it is another one; none where it is what holds without one.
template <class T>
void put(Json& json, const char* key, const T& now, const T& was, const T& unsaid) {
  if (now == was) return;
  if (now == unsaid) {
    json.erase(key);
  } else {
    json[key] = said(now);
  }
}

/// What differs from `was`, but for instances. A matrix stays one.
void put_node(const Node& now, const Node& was, Json& json) {
  const Node unsaid{};
  put(json, "name", now.name, was.name, unsaid.name);
  if (now.matrix && now.matrix != was.matrix) {
    const float* values = glm::value_ptr(*now.matrix);
    json["matrix"] = std::vector<float>(values, values + 16);
  }
  if (!now.matrix) {
    put(json, "translation", now.transform.translation, was.transform.translation, unsaid.transform.translation);
    put(json, "rotation", now.transform.rotation, was.transform.rotation, unsaid.transform.rotation);
    put(json, "scale", now.transform.scale, was.transform.scale, unsaid.transform.scale);
  }
  if (now.mesh && !was.mesh) json["mesh"] = *now.mesh;
  if (!now.mesh && was.mesh) json.erase("mesh");
  if (now.skin && !was.skin) json["skin"] = *now.skin;
  put(json, "weights", now.weights, was.weights, unsaid.weights);
  put(json, "children", now.children, was.children, unsaid.children);
}

}  // namespace

bool all_finite(std::span<const float> values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

std::optional<Refusal> patch_nodes(const Scene& scene, const Scene& was, Json& json, AccessorStore& store,
                                   std::set<std::size_t>& left) {
  const std::size_t old = was.nodes.size();
  if (scene.nodes.size() < old) return Refusal{"nodes", "some were removed"};
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& now = scene.nodes[i];
    const std::string why = i < old ? why_not(now, was.nodes[i], old) : why_not_said(now);
    if (!why.empty()) return Refusal{place_of(i), why};
  }
  if (auto refusal = why_no_tree(scene.nodes)) return refusal;
  for (std::size_t i = 0; i < old; ++i) {
    Json& node = json["nodes"][i];
    put_node(scene.nodes[i], was.nodes[i], node);
    if (scene.nodes[i].instances == was.nodes[i].instances) continue;
    patch_instancing(scene.nodes[i].instances.view(), was.nodes[i].instances.view(),
                     node["extensions"][mesh_gpu_instancing]["attributes"], store, left);
  }
  const std::vector<NodeId> roots = old_ones(scene.roots, old);
  if (roots == was.roots) return std::nullopt;
  if (sorted(roots) != sorted(was.roots)) return Refusal{"the scene's roots", "some were added or removed"};
  json["scenes"][json.value("scene", std::size_t{0})]["nodes"] = roots;
  return std::nullopt;
}

void add_nodes(const Scene& scene, std::size_t old, Json& json, AccessorStore& store) {
  for (std::size_t i = old; i < scene.nodes.size(); ++i) {
    Json node = Json::object();
    put_node(scene.nodes[i], {}, node);
    list_in(json, "nodes")[i] = std::move(node);
    if (const auto instances = scene.nodes[i].instances.view(); !instances.empty()) {
      json["nodes"][i]["extensions"][mesh_gpu_instancing] = instancing_of(instances, store);
      // Who does not know it would show one where there are many, also in a file that could do without it so far.
      for (const char* list : {"extensionsUsed", "extensionsRequired"}) listed(json[list], mesh_gpu_instancing);
    }
  }
  for (const NodeId root : roots_of(scene)) {
    if (root < old || !scene.nodes[root].is_shown) continue;  // a coarser node is in no scene
    if (!json.contains("scene")) json["scene"] = 0;
    Json& shown = list_in(json, "scenes")[json["scene"].get<std::size_t>()];
    if (shown.is_null()) shown = Json::object();
    list_in(shown, "nodes").push_back(root);
  }
}

}  // namespace foredraw::gltf
