// Checks of nodes, scenes and skins.
#include <foredraw/io/gltf/private/gate.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace foredraw::gltf {

namespace {

/// The references in an array; wrong ones are left out.
std::vector<std::size_t> references(Gate& gate, const Json& parent, const char* key, const char* kind,
                                    const std::string& place) {
  std::vector<std::size_t> result;
  const Json* values = gate.array(parent, key, place);
  for (std::size_t i = 0; values != nullptr && i < values->size(); ++i) {
    if (const auto number = gate.reference((*values)[i], kind, at(in(place, key), i))) result.push_back(*number);
  }
  return result;
}

/// Every node has one parent at most, and nobody is an own ancestor.
void check_tree(Gate& gate, const std::vector<std::vector<std::size_t>>& children) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> parent(children.size(), none);
  bool one_parent = true;
  for (std::size_t i = 0; i < children.size(); ++i) {
    for (std::size_t child : children[i]) {
      if (parent[child] != none) {
        gate.error(in(at("nodes", i), "children"), "node-parents",
                   fmt::format("node {} is already a child of node {}", child, parent[child]));
        one_parent = false;
      }
      parent[child] = i;
    }
  }
  if (!one_parent) return;
  std::vector<std::size_t> seen_from(children.size(), none);
  for (std::size_t i = 0; i < children.size(); ++i) {
    for (std::size_t node = i; node != none && seen_from[node] != i; node = parent[node]) {
      if (seen_from[node] != none) break;  // the way up from here was followed before
      seen_from[node] = i;
      if (parent[node] != none && seen_from[parent[node]] == i) {
        gate.error(at("nodes", parent[node]), "node-cycle", "is its own ancestor");
      }
    }
  }
}

void check_matrix(Gate& gate, const Json& node, const std::string& place) {
  if (!node.contains("matrix") || !gate.numbers(node, "matrix", place, 16)) return;
  const Json& m = node["matrix"];
  if (m[3].get<double>() == 0 && m[7].get<double>() == 0 && m[11].get<double>() == 0 && m[15].get<double>() == 1)
    return;
  gate.error(in(place, "matrix"), "out-of-range", "the last row must be 0, 0, 0, 1");
}

}  // namespace

void check_nodes(Gate& gate) {
  const Json& nodes = gate.all("nodes");
  std::vector<std::vector<std::size_t>> children;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string place = at("nodes", i);
    children.push_back(references(gate, nodes[i], "children", "nodes", place));
    gate.reference(nodes[i], "mesh", "meshes", place);
    gate.reference(nodes[i], "skin", "skins", place);
    gate.reference(nodes[i], "camera", "cameras", place);
    check_matrix(gate, nodes[i], place);
    for (const auto& [key, size] : {std::pair{"translation", 3}, {"rotation", 4}, {"scale", 3}, {"weights", 0}}) {
      if (nodes[i].contains(key)) gate.numbers(nodes[i], key, place, static_cast<std::size_t>(size));
    }
  }
  check_tree(gate, children);
  const Json& scenes = gate.all("scenes");
  for (std::size_t i = 0; i < scenes.size(); ++i) references(gate, scenes[i], "nodes", "nodes", at("scenes", i));
  gate.reference(gate.json(), "scene", "scenes", {});
}

namespace {

/// Joint numbers are followed by whoever poses the vertices, so they are held against the skin's joints. Each accessor
/// and each mesh is looked through once, however many nodes draw it.
class JointCheck {
 public:
  explicit JointCheck(Gate& gate) : gate_(gate) {}

  void check(std::size_t mesh, std::size_t joints, const std::string& place) {
    const auto [known, is_new] = meshes_.try_emplace(mesh);
    if (is_new) known->second = greatest_in_mesh(mesh);
    const auto& [joint, where] = known->second;
    if (where.empty() || joint < joints) return;
    gate_.error(place, "joint-range",
                fmt::format("{} names joint {}, but the skin has {} joints", where, joint, joints));
  }

 private:
  struct Greatest {
    std::uint32_t joint = 0;
    std::string where;  ///< empty: there are none
  };

  Greatest greatest_in_mesh(std::size_t mesh) {
    Greatest greatest;
    const Json& primitives = gate_.all("meshes")[mesh]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      for (const auto& [semantic, number] : primitives[p]["attributes"].items()) {
        if (semantic.compare(0, 7, "JOINTS_") != 0) continue;
        const std::uint32_t joint = greatest_in_accessor(number.get<std::size_t>());
        if (!greatest.where.empty() && joint <= greatest.joint) continue;
        greatest = {joint, fmt::format("meshes[{}].primitives[{}].attributes.{}", mesh, p, semantic)};
      }
    }
    return greatest;
  }

  std::uint32_t greatest_in_accessor(std::size_t number) {
    const auto [known, is_new] = accessors_.try_emplace(number, 0);
    if (!is_new) return known->second;
    // Four joints a vertex, read as so many single numbers.
    const Accessor& fours = *gate_.accessor(number);
    const std::vector<std::byte> bytes = elements(gate_.document(), fours);
    const std::size_t width = bytes_of(fours.format.component);
    for (std::size_t i = 0; i < bytes.size(); i += width) {
      std::uint32_t joint = 0;
      std::memcpy(&joint, bytes.data() + i, width);
      known->second = std::max(known->second, joint);
    }
    return known->second;
  }

  Gate& gate_;
  std::map<std::size_t, Greatest> meshes_;
  std::map<std::size_t, std::uint32_t> accessors_;
};

}  // namespace

void check_skins(Gate& gate) {
  const Json& skins = gate.all("skins");
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const std::string place = at("skins", i);
    gate.required(skins[i], "joints", place);
    const std::vector<std::size_t> joints = references(gate, skins[i], "joints", "nodes", place);
    if (skins[i].contains("joints") && skins[i]["joints"].is_array() && skins[i]["joints"].empty()) {
      gate.error(in(place, "joints"), "out-of-range", "must not be empty");
    }
    if (std::set(joints.begin(), joints.end()).size() != joints.size()) {
      gate.error(in(place, "joints"), "out-of-range", "names a node twice");
    }
    gate.reference(skins[i], "skeleton", "nodes", place);
    const auto number = gate.reference(skins[i], "inverseBindMatrices", "accessors", place);
    const Accessor* matrices = gate.accessor(number);
    if (matrices == nullptr) continue;
    if (matrices->format.component != Component::float32 || matrices->format.components != 16) {
      gate.error(in(place, "inverseBindMatrices"), "accessor-type",
                 fmt::format("accessor {} must be MAT4 of floats", *number));
    }
    if (matrices->count < joints.size()) {
      gate.error(in(place, "inverseBindMatrices"), "unequal-counts",
                 fmt::format("accessor {} has {} matrices for {} joints", *number, matrices->count, joints.size()));
    }
  }
  if (!gate.sound()) return;
  JointCheck joint_check(gate);
  std::set<std::pair<std::size_t, std::size_t>> seen;
  const Json& nodes = gate.all("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("mesh") || !nodes[i].contains("skin")) continue;
    const auto mesh = nodes[i]["mesh"].get<std::size_t>();
    const auto skin = nodes[i]["skin"].get<std::size_t>();
    if (seen.emplace(mesh, skin).second) joint_check.check(mesh, skins[skin]["joints"].size(), at("nodes", i));
  }
}

}  // namespace foredraw::gltf
