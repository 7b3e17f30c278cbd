#pragma once
// Materials of which the draws keep their units and texture coordinates. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

/// Sets Material::keeps_spaces of all that variants (KHR_materials_variants) or coarser materials (MSFT_lod) exchange,
/// of those that an animation pointer names, and of those that say what we do not know, or moved surfaces of which we
/// can not tell how. The gate has looked at the document.
void find_kept_spaces(Scene& scene, const Document& document);

}  // namespace foredraw::gltf
