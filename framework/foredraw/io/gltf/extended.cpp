// Draws that an extension may refer to by triangle or vertex: the one trait that the scene itself does not show.
#include <foredraw/io/gltf/private/source.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

/// Of a primitive: whether it says nothing about triangles or vertices, or the writer makes it anew, takes it along or
/// leaves it out. Products hold on to draws themselves.
bool is_harmless(std::string_view name, const ProductRows& products) {
  return name == "KHR_materials_variants" ||
         std::ranges::any_of(products, [&](const auto& row) { return row->card().extension == name; });
}

bool is_extended(const Json& primitive, const ProductRows& products) {
  const auto extensions = primitive.find("extensions");
  if (extensions == primitive.end() || !extensions->is_object()) return false;
  for (const auto& [name, value] : extensions->items()) {
    if (!is_harmless(name, products)) return true;
  }
  return false;
}

}  // namespace

void find_extended(Scene& scene, const Document& document) {
  for (Draw& draw : scene.draws) {
    const Json& primitive = document.json["meshes"][draw.origin->mesh]["primitives"][draw.origin->primitive];
    if (is_extended(primitive, document.products)) draw.traits.add(traits::extended);
  }
}

}  // namespace foredraw::gltf
