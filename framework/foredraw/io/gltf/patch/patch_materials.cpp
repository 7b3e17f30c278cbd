// Materials put back: what a stage changed of them, and new ones.
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/displacement.h>
#include <foredraw/io/gltf/private/material_textures.h>
#include <foredraw/io/gltf/private/texture_places.h>
#include <foredraw/io/gltf/private/thickness.h>

namespace foredraw::gltf {

namespace {

const char* word(AlphaMode mode) {
  return mode == AlphaMode::blend ? "BLEND" : mode == AlphaMode::mask ? "MASK" : "OPAQUE";
}

/// Says only what differs from `was`.
void put_members(Json& json, const Material& now, const Material& was) {
  if (now.name != was.name) json["name"] = now.name;
  if (now.alpha_mode != was.alpha_mode) json["alphaMode"] = word(now.alpha_mode);
  if (now.alpha_mode != AlphaMode::mask && now.alpha_mode != was.alpha_mode) json.erase("alphaCutoff");
  if (now.alpha_mode == AlphaMode::mask && now.alpha_cutoff != was.alpha_cutoff) json["alphaCutoff"] = now.alpha_cutoff;
  if (now.double_sided != was.double_sided) json["doubleSided"] = now.double_sided;
}

/// What a texture that the material did not have makes of it. Whatever the document lists may move in memory.
Json textured_surface(Json& document, const Material& now, const Texture& texture) {
  Json surface = Json::object();
  if (now.alpha != 1) surface["baseColorFactor"] = {1, 1, 1, now.alpha};
  surface["baseColorTexture"] = texture_use(texture, document);
  surface["metallicFactor"] = 0;
  return surface;
}

}  // namespace

void put_material(std::size_t number, const Material& now, const Material& was, Json& document) {
  put_members(document["materials"][number], now, was);
  put_texture_places(now, was, document["materials"][number]);
  put_displacement(number, now, was, document);
  put_thickness(number, now, was, document);
  if (now.base_colour && now.base_colour->image && !was.base_colour) {
    const Json surface = textured_surface(document, now, *now.base_colour);
    document["materials"][number]["pbrMetallicRoughness"].update(surface);
  }
  list_texture_transform(now, document["materials"][number], document);
}

}  // namespace foredraw::gltf
