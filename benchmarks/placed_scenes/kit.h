#pragma once
// Models that make up a scene when they are placed many times.

#include "kit_document.h"

#include <foredraw/scene/scene.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::bench {

struct KitModel {
  std::string name;
  std::vector<Node> nodes;  ///< a tree: the first is the root and stands at the origin; children are numbers in here
  std::uint64_t primitives = 0;  ///< that one placement of the model draws
};

struct Kit {
  Scene scene;  ///< meshes, materials and images of all models; of nodes, none that belongs to a model
  std::vector<KitModel> models;

  /// The number of the model of that name. Throws std::runtime_error where there is none.
  std::size_t model(std::string_view name) const;
};

/// Every .gltf and .glb of a folder, sorted by name, as models. Materials and images of equal content are one. The
/// scene is written with all properties that the kit's materials have. Throws std::runtime_error where that fails.
Kit read_kit(const std::filesystem::path& folder);

/// The models that were added to a document. What nodes the document has, with cameras, skins and animations, are the
/// first of every scene of the kit. Throws std::runtime_error where it is not glTF.
Kit kit_of(const GltfDocument& document, std::span<const KitDocument::Model> models, const std::string& name);

/// A model somewhere in the scene.
struct Placement {
  std::size_t model = 0;
  Transform transform;
};

/// The kit's scene with a copy of the model's nodes for each placement, behind the nodes that it has.
Scene placed_scene(const Kit& kit, std::span<const Placement> placements, std::string name);

}  // namespace foredraw::bench
