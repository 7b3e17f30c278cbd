#pragma once
// The materials of the made-up models, by name, in the document as far as something uses them.

#include "kit_document.h"
#include "surfaces.h"

#include <map>
#include <string_view>
#include <vector>

namespace foredraw::bench {

class Palette {
 public:
  explicit Palette(GltfDocument& to) : to_(to) {}

  /// The number of the material. Throws std::runtime_error where there is none of this name.
  std::size_t operator[](std::string_view name);

 private:
  GltfDocument& to_;
  std::map<std::string, std::size_t, std::less<>> added_;
};

/// Triangles that have one material; the mesh need not be finished.
struct ModelPart {
  SurfaceMesh mesh;
  std::string_view material;
};

/// Adds a mesh with a primitive for each part, and gives a model of one node that shows it.
KitDocument::Model add_model(GltfDocument& to, Palette& palette, std::string name, std::vector<ModelPart> parts);

}  // namespace foredraw::bench
