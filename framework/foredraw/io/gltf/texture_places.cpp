#include <foredraw/io/gltf/private/texture_places.h>

#include <foredraw/io/gltf/private/material_textures.h>
#include <foredraw/io/gltf/private/texture_uses.h>
#include <foredraw/scene/scaled_texcoords.h>

namespace foredraw::gltf {

namespace {

/// Numbers that were scaled more than once are the scene's own: composed in one step they may differ in the last bit.
void put_own_place(const std::optional<Texture>& now, const std::optional<Texture>& was, Json& use) {
  if (now && was && differ_in_place_alone(*now, *was)) put_place(*now, use);
}

}  // namespace

void put_texture_places(const Material& now, const Material& was, Json& material) {
  each_texture_use(material, [&](std::string_view, Json& use) {
    Texture place;
    add_place(place, use);
    Texture moved = place;
    for (const ScaledTexcoords& scaled : now.scaled_texcoords) moved = with_scaled_texcoords(moved, scaled);
    if (moved != place) put_place(moved, use);
  });
  if (was.base_colour)
    put_own_place(now.base_colour, was.base_colour, material["pbrMetallicRoughness"]["baseColorTexture"]);
  if (was.normal_map) put_own_place(now.normal_map, was.normal_map, material["normalTexture"]);
}

void list_texture_transform(const Material& now, const Json& material, Json& document) {
  if (now.scaled_texcoords.empty()) return;
  bool has_any = false;
  each_texture_use(material, [&](std::string_view, const Json& use) {
    has_any = has_any || extension_of(use, texture_transform) != nullptr;
  });
  if (!has_any) return;
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) list_extension(document, list, texture_transform);
}

}  // namespace foredraw::gltf
