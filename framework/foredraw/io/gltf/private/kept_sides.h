#pragma once
// Materials of which the sides that are drawn have to stay. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

/// Sets Material::keeps_sides of all that the file says light passes through, that an animation pointer names, or that
/// a variant (KHR_materials_variants) may put one in place of which shows other sides, or is not as opaque.
void find_kept_sides(Scene& scene, const Json& document);

}  // namespace foredraw::gltf
