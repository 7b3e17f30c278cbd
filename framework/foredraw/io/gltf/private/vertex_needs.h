#pragma once
// What materials need of vertices. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

/// Sets Material::needs of all whose extensions we know. What may be put in a material's place, by variants or as
/// MSFT_lod, counts as its own. The gate has looked at the document.
void find_vertex_needs(Scene& scene, const Document& document);

}  // namespace foredraw::gltf
