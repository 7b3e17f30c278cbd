#pragma once
// Textures whose coordinates stages put into other units. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/material.h>

namespace foredraw::gltf {

/// Puts what differs from `was` into KHR_texture_transform of the textures that the JSON of the material looks up: into
/// all that are looked up by the sets of Material::scaled_texcoords, in extensions too.
void put_texture_places(const Material& now, const Material& was, Json& material);

/// Lists KHR_texture_transform as used and required where coordinates are in other units, and a texture in the JSON of
/// the material has a transform: who does not know it would show another part of the image.
void list_texture_transform(const Material& now, const Json& material, Json& document);

}  // namespace foredraw::gltf
