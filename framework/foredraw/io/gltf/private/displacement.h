#pragma once
// KHR_materials_displacement, which is a proposal. Its members are named as the programs that read it name them today.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/material.h>

namespace foredraw::gltf {

inline constexpr const char* displacement_extension = "KHR_materials_displacement";

/// From the JSON of a material and the whole document's, which the gate has checked.
void add_displacement(Material& material, const Json& from, const Json& document);

/// What differs from `was`. Other members of the extension stay. Whatever the document lists may move in memory, so the
/// material is given by its number.
void put_displacement(std::size_t material, const Material& now, const Material& was, Json& document);

}  // namespace foredraw::gltf
