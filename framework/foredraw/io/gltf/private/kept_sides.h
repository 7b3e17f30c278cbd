#pragma once
// Materials of which the sides that are drawn have to stay. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

/// Sets Material::keeps_sides of all that the file says light passes through, or that an animation pointer names.
void find_kept_sides(Scene& scene, const Json& document);

}  // namespace foredraw::gltf
