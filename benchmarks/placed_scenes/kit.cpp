#include "kit.h"

#include <foredraw/io/gltf/gltf.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw::bench {

namespace fs = std::filesystem;

namespace {

Node node_of(const KitDocument::ModelNode& from) {
  Node node;
  if (from.mesh) node.mesh = static_cast<MeshId>(*from.mesh);
  for (const std::size_t child : from.children) node.children.push_back(static_cast<NodeId>(child));
  const auto number = [&](const char* key, std::size_t i) { return from.placement[key].at(i).get<float>(); };
  Transform& t = node.transform;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (from.placement.contains("translation")) t.translation[i] = number("translation", at);
    if (from.placement.contains("scale")) t.scale[i] = number("scale", at);
  }
  if (from.placement.contains("rotation")) {
    t.rotation = glm::quat(number("rotation", 3), number("rotation", 0), number("rotation", 1), number("rotation", 2));
  }
  return node;
}

}  // namespace

std::size_t Kit::model(std::string_view name) const {
  const auto found = std::ranges::find(models, name, &KitModel::name);
  if (found == models.end()) throw std::runtime_error("the kit has no model '" + std::string(name) + "'");
  return static_cast<std::size_t>(found - models.begin());
}

Kit read_kit(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  if (files.empty()) throw std::runtime_error(folder.string() + ": holds no .gltf or .glb file");

  GltfDocument gltf;
  KitDocument document(gltf);
  std::vector<KitDocument::Model> models;
  for (const fs::path& file : files) models.push_back(document.add(file));
  return kit_of(gltf, models, folder.filename().string());
}

Kit kit_of(const GltfDocument& document, std::span<const KitDocument::Model> models, const std::string& name) {
  Diagnostics diagnostics;
  auto scene = read_gltf(document.glb(), name, {}, diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  Kit kit{std::move(*scene), {}};
  for (const KitDocument::Model& from : models) {
    KitModel model{from.name, {}, 0};
    for (const KitDocument::ModelNode& node : from.nodes) {
      model.nodes.push_back(node_of(node));
      if (node.mesh) model.primitives += kit.scene.meshes[*node.mesh].draws.size();
    }
    kit.models.push_back(std::move(model));
  }
  return kit;
}

Scene placed_scene(const Kit& kit, std::span<const Placement> placements, std::string name) {
  Scene scene = kit.scene;
  scene.name = std::move(name);
  std::size_t count = 0;
  for (const Placement& placement : placements) count += kit.models[placement.model].nodes.size();
  scene.nodes.reserve(count);
  std::vector<std::size_t> times(scene.meshes.size(), 0);
  for (const Placement& placement : placements) {
    const auto first = static_cast<NodeId>(scene.nodes.size());
    for (const Node& from : kit.models[placement.model].nodes) {
      Node& node = scene.nodes.emplace_back(from);
      for (NodeId& child : node.children) child += first;
      if (node.mesh) ++times[*node.mesh];
    }
    scene.nodes[first].transform = placement.transform;
  }
  for (MeshId mesh = 0; mesh < times.size(); ++mesh) {
    if (times[mesh] < 2) continue;
    for (const DrawId draw : scene.meshes[mesh].draws) scene.draws[draw].traits.add(traits::instanced);
  }
  return scene;
}

}  // namespace foredraw::bench
