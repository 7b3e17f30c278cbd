#pragma once
// What a file does to materials while it is shown. Private to io.

#include <foredraw/io/gltf/private/document.h>

namespace foredraw::gltf {

/// The materials that a primitive's variants (KHR_materials_variants) may put in place of its own. The document need
/// not have that many.
std::vector<std::size_t> variants_of(const Json& primitive);

/// The materials that stand for this one from far away (MSFT_lod). The document need not have that many.
std::vector<std::size_t> coarser_materials(const Json& material);

/// The materials of which an animation moves something (KHR_animation_pointer). The document need not have that many.
std::set<std::size_t> animated_materials(const Json& document);

}  // namespace foredraw::gltf
