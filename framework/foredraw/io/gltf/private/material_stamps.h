#pragma once
// Which materials look alike, and which differ in numbers alone. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/material.h>

namespace foredraw::gltf {

void add_stamps(Material& material, const Json& json);

}  // namespace foredraw::gltf
