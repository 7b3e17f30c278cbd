#include <foredraw/io/gltf/private/base_colour.h>

#include <foredraw/io/gltf/private/material_textures.h>

namespace foredraw::gltf {

void add_base_colour(Material& material, const Json& from, const Json& document) {
  const Json& surface = object_in(from, "pbrMetallicRoughness");
  const Json& factor = object_in(surface, "baseColorFactor");
  for (int i = 0; i < 3; ++i) {
    material.colour[i] = static_cast<float>(number_in(factor, static_cast<std::size_t>(i), 1));
  }
  material.alpha = static_cast<float>(number_in(factor, std::size_t{3}, 1));
  material.base_colour = texture_of(object_in(surface, "baseColorTexture"), document);
  material.normal_map = texture_of(object_in(from, "normalTexture"), document);
  if (material.normal_map)
    material.normal_scale = static_cast<float>(number_in(object_in(from, "normalTexture"), "scale", 1));
}

}  // namespace foredraw::gltf
