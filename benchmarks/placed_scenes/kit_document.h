#pragma once
// The models of a kit in one glTF document: their meshes, and of their materials and images those that differ.

#include "gltf_document.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foredraw::bench {

/// The JSON is copied as it is, so that every property of a material is kept, known here or not. Of materials,
/// textures, samplers and images, those with equal content (whatever they are called) become one. Throws
/// std::runtime_error for files that can not be read; what is in them is only trusted as far as the kits of the corpus
/// may be.
class KitDocument {
 public:
  using Json = GltfDocument::Json;

  /// The document that models are added to; it has to live as long as this.
  explicit KitDocument(GltfDocument& to) : to_(to) {}

  struct ModelNode {
    Json placement = Json::object();  ///< its "translation", "rotation" and "scale", as far as it has them
    std::optional<std::size_t> mesh;  ///< of this document
    std::vector<std::size_t> children;
  };

  /// A tree; nodes[0] is the root, and none comes before its parent.
  struct Model {
    std::string name;
    std::vector<ModelNode> nodes;
  };

  /// Adds the model in a .gltf or .glb, and says what it is made of. It is called after the file; its root, the first
  /// node of the scene, stands at the origin, wherever it stood in the file.
  Model add(const std::filesystem::path& file);

 private:
  GltfDocument& to_;
};

}  // namespace foredraw::bench
