// Checks of nodes and scenes.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

#include <cmath>

namespace foredraw::gltf {

namespace {

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

void check_rotation(Gate& gate, const Json& node, const std::string& place) {
  const auto rotation = node.find("rotation");
  if (!gate.sound() || rotation == node.end()) return;
  double length = 0;
  for (const Json& value : *rotation) length += value.get<double>() * value.get<double>();
  if (std::abs(length - 1) < 1e-2) return;
  gate.fault("quaternion", in(place, "rotation"),
             fmt::format("its length is {:.3g}, but must be 1", std::sqrt(length)));
}

}  // namespace

void check_nodes(Gate& gate) {
  const Json& nodes = gate.all("nodes");
  std::vector<std::vector<std::size_t>> children;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string place = at("nodes", i);
    children.push_back(gate.references(nodes[i], "children", "nodes", place));
    gate.reference(nodes[i], "mesh", "meshes", place);
    gate.reference(nodes[i], "skin", "skins", place);
    gate.leave_out_if_wrong("camera", in(place, "camera"),
                            [&] { gate.reference(nodes[i], "camera", "cameras", place); });
    check_matrix(gate, nodes[i], place);
    for (const auto& [key, size] : {std::pair{"translation", 3}, {"rotation", 4}, {"scale", 3}, {"weights", 0}}) {
      if (nodes[i].contains(key)) gate.numbers(nodes[i], key, place, static_cast<std::size_t>(size));
    }
    check_rotation(gate, nodes[i], place);
  }
  check_tree(gate, children);
  const Json& scenes = gate.all("scenes");
  for (std::size_t i = 0; i < scenes.size(); ++i) gate.references(scenes[i], "nodes", "nodes", at("scenes", i));
  gate.leave_out_if_wrong("scene", "scene", [&] { gate.reference(gate.json(), "scene", "scenes", {}); });
}

}  // namespace foredraw::gltf
