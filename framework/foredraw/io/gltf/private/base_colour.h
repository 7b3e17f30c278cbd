#pragma once
#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/material.h>

namespace foredraw::gltf {

/// The alpha and the texture of the base colour of a material, from its JSON and the whole document's, which the gate
/// has checked. What is no number where one should be counts as absent.
void add_base_colour(Material& material, const Json& from, const Json& document);

}  // namespace foredraw::gltf
