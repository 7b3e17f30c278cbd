#include <foredraw/io/gltf/private/displacement.h>

#include <foredraw/io/gltf/private/material_textures.h>

namespace foredraw::gltf {

void add_displacement(Material& material, const Json& from, const Json& document) {
  const Json* extension = extension_of(from, displacement_extension);
  if (extension == nullptr || !extension->is_object()) return;
  const auto texture = texture_of(object_in(*extension, "displacementGeometryTexture"), document);
  if (!texture) return;
  material.displacement = {*texture, static_cast<float>(number_in(*extension, "displacementGeometryFactor", 1)),
                           static_cast<float>(number_in(*extension, "displacementGeometryOffset", 0))};
}

void put_displacement(std::size_t material, const Material& now, const Material& was, Json& document) {
  if (now.displacement == was.displacement) return;
  Json& json = document["materials"][material];
  if (!now.displacement) {
    json["extensions"].erase(displacement_extension);
    if (json["extensions"].empty()) json.erase("extensions");
    return;
  }
  const Displacement& put = *now.displacement;
  Json members = JsonObject{{"displacementGeometryFactor", put.factor}, {"displacementGeometryOffset", put.offset}};
  const bool is_moved = was.displacement && differ_in_place_alone(put.texture, was.displacement->texture);
  if (is_moved) {
    put_place(put.texture, json["extensions"][displacement_extension]["displacementGeometryTexture"]);
    listed(document["extensionsUsed"], texture_transform);
  } else if (!was.displacement || put.texture != was.displacement->texture) {
    members["displacementGeometryTexture"] = texture_use(put.texture, document);
  }
  Json& extension = document["materials"][material]["extensions"][displacement_extension];
  if (extension.is_null()) extension = Json::object();
  extension.update(members);
  listed(document["extensionsUsed"], displacement_extension);
}

}  // namespace foredraw::gltf
