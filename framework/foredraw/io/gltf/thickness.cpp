#include <foredraw/io/gltf/private/thickness.h>

#include <foredraw/io/gltf/private/material_textures.h>

namespace foredraw::gltf {

namespace {

constexpr const char* thickness_factor = "thicknessFactor";

}  // namespace

void add_thickness(Material& material, const Json& from) {
  const Json* extension = extension_of(from, volume_extension);
  if (extension == nullptr) return;
  const auto thickness = static_cast<float>(number_in(*extension, thickness_factor, 0));
  if (thickness != 0) material.thickness = thickness;
}

void put_thickness(std::size_t material, const Material& now, const Material& was, Json& document) {
  if (now.thickness == was.thickness) return;
  Json& extension = document["materials"][material]["extensions"][volume_extension];
  if (!extension.is_object()) extension = Json::object();
  if (now.thickness) {
    extension[thickness_factor] = *now.thickness;
    listed(document["extensionsUsed"], volume_extension);
  } else {
    extension.erase(thickness_factor);
  }
}

}  // namespace foredraw::gltf
