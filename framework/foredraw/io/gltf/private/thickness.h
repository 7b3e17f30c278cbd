#pragma once
// KHR_materials_volume's thickness, the one length of it that is in the units of the draws. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/material.h>

namespace foredraw::gltf {

inline constexpr const char* volume_extension = "KHR_materials_volume";

/// From the JSON of a material, which the gate has checked.
void add_thickness(Material& material, const Json& from);

/// What differs from `was`. Other members of the extension stay. The material is given by its number.
void put_thickness(std::size_t material, const Material& now, const Material& was, Json& document);

}  // namespace foredraw::gltf
