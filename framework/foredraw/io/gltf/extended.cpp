// Draws that an extension may refer to by triangle or vertex: the one trait that the scene itself does not show.
#include <foredraw/io/gltf/private/draw_orders.h>
#include <foredraw/io/gltf/private/source.h>

namespace foredraw::gltf {

namespace {

/// Extensions of a primitive that say nothing about its triangles or vertices, or that the writer makes anew, takes
/// along or leaves out.
bool is_harmless(std::string_view name) {
  return name == "KHR_materials_variants" || name == "KHR_draco_mesh_compression" || name == draw_orders;
}

bool is_extended(const Json& primitive) {
  const auto extensions = primitive.find("extensions");
  if (extensions == primitive.end() || !extensions->is_object()) return false;
  for (const auto& [name, value] : extensions->items()) {
    if (!is_harmless(name)) return true;
  }
  return false;
}

}  // namespace

void find_extended(Scene& scene, const Document& document) {
  for (Draw& draw : scene.draws) {
    const Json& primitive = document.json["meshes"][draw.origin->mesh]["primitives"][draw.origin->primitive];
    if (is_extended(primitive)) draw.traits.add(traits::extended);
  }
}

}  // namespace foredraw::gltf
