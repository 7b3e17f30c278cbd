#include <foredraw/io/gltf/private/vertex_needs.h>

#include <foredraw/io/gltf/private/each_extension.h>
#include <foredraw/io/gltf/private/exchanged_materials.h>
#include <foredraw/io/gltf/private/material_textures.h>
#include <foredraw/io/gltf/private/texture_uses.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

constexpr std::uint32_t most_sets = 32;  // as many as a VertexNeeds can tell apart

/// What a use of a texture needs: its set, and the one that a transform puts in its place for viewers that know it.
/// False where a set is beyond those that can be told.
bool add_use(std::string_view name, const Json& use, VertexNeeds& needs) {
  const Json* transform = extension_of(use, texture_transform);
  const double outer = number_in(use, "texCoord", 0);
  for (const double set : {outer, transform ? number_in(*transform, "texCoord", outer) : outer}) {
    if (!(set >= 0 && set < most_sets)) return false;
    needs.texcoords |= 1u << static_cast<std::uint32_t>(set);
  }
  if (name.ends_with("ormalTexture")) needs.has_tangents = true;
  return true;
}

/// Nothing where a need is not known.
std::optional<VertexNeeds> needs_of(const Json& material, const Document& document) {
  VertexNeeds needs;
  bool are_known = true;
  each_extension(material, [&](const std::string& name, const Json&) {
    are_known = are_known && document.knows_extension(name);
    if (name == "KHR_materials_anisotropy") needs.has_tangents = true;
  });
  each_texture_use(material,
                   [&](std::string_view name, const Json& use) { are_known = add_use(name, use, needs) && are_known; });
  return are_known ? std::optional(needs) : std::nullopt;
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
    materials[m].needs = needs_of(document.json["materials"][m], document);
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
