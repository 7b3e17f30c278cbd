#pragma once
// Materials that are made up: with a base colour texture and a normal map, with the texture alone, and plain.

#include "gltf_document.h"
#include "surface_mesh.h"

#include <functional>
#include <string>

namespace foredraw::bench {

/// From 0 to 1 over a square that repeats: how high a surface is, and how light.
using Pattern = std::function<double(const glm::dvec2&)>;

Pattern bark_pattern();
Pattern leaf_pattern();
Pattern stone_pattern();
Pattern marble_pattern();
Pattern plank_pattern();
Pattern plaster_pattern();
Pattern cloth_pattern();
Pattern paving_pattern();
Pattern soil_pattern();

struct Surface {
  std::string name;
  glm::dvec3 dark{0.2}, light{0.8};  ///< the texture's colours at heights 0 and 1; plain ones have the light one
  Pattern pattern = {};              ///< none: it is plain, and has factors alone
  double bump = 0;                   ///< how steep the normal map is; 0: there is none
  double roughness = 0.8, metallic = 0;
  bool is_double_sided = false;
};

/// Adds the material, and its textures as PNG of 256 x 256 texels.
std::size_t add_surface(GltfDocument& to, const Surface& surface);

/// A primitive of the mesh with all that the material wants: texture coordinates where it has a texture, tangents where
/// it has a normal map. The mesh is finished (surface_mesh.h).
GltfDocument::Json add_primitive(GltfDocument& to, const SurfaceMesh& mesh, std::size_t material);

}  // namespace foredraw::bench
