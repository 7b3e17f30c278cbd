#include <foredraw/io/gltf/private/vertex_needs.h>

#include <foredraw/io/gltf/private/exchanged_materials.h>
#include <foredraw/io/gltf/private/material_textures.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

constexpr std::uint32_t most_sets = 32;  // as many as a VertexNeeds can tell apart

/// What a use of a texture needs: its set, and the one that a transform puts in its place for viewers that know it.
/// False where a set is beyond those that can be told.
bool add_use(std::string_view name, const Json& use, VertexNeeds& needs) {
  const Json* transform = extension_of(use, "KHR_texture_transform");
  for (const double set : {number_in(use, "texCoord", 0), transform ? number_in(*transform, "texCoord", 0) : 0.0}) {
    if (!(set >= 0 && set < most_sets)) return false;
    needs.texcoords |= 1u << static_cast<std::uint32_t>(set);
  }
  if (name.ends_with("ormalTexture")) needs.has_tangents = true;
  return true;
}

/// Adds the needs of all textures in the value, wherever extensions hold them. False where one is not known.
bool add_uses(const Json& value, const Document& document, VertexNeeds& needs) {
  if (!value.is_object()) return true;
  for (const auto& [name, part] : value.items()) {
    if (name == "extras" || !part.is_object()) continue;
    if (name == "extensions") {
      for (const auto& [extension, held] : part.items()) {
        if (!document.knows_extension(extension)) return false;
        if (extension == "KHR_materials_anisotropy") needs.has_tangents = true;
      }
    }
    if (part.contains("index") && !add_use(name, part, needs)) return false;
    if (!add_uses(part, document, needs)) return false;
  }
  return true;
}

void take_on(std::optional<VertexNeeds>& needs, const std::optional<VertexNeeds>& others) {
  if (needs && others) {
    needs->texcoords |= others->texcoords;
    needs->has_tangents |= others->has_tangents;
  } else {
    needs.reset();
  }
}

}  // namespace

void find_vertex_needs(Scene& scene, const Document& document) {
  std::vector<Material>& materials = scene.materials;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    VertexNeeds needs;
    if (add_uses(document.json["materials"][m], document, needs)) materials[m].needs = needs;
  }
  const auto others = [&](std::size_t m, const std::vector<std::size_t>& numbers) {
    for (const std::size_t other : numbers) {
      take_on(materials[m].needs, other < materials.size() ? materials[other].needs : std::nullopt);
    }
  };
  for (std::size_t m = 0; m < materials.size(); ++m) others(m, coarser_materials(document.json["materials"][m]));
  each_primitive(document.json, [&](const Json& primitive) {
    const auto own = primitive.find("material");
    if (own != primitive.end() && *own < materials.size()) others(own->get<std::size_t>(), variants_of(primitive));
  });
}

}  // namespace foredraw::gltf
