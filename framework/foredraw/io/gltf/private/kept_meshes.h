#pragma once
// Which nodes' meshes another node can not draw in their place. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

/// Sets keeps_mesh of every node. The gate has looked at the document.
void find_kept_meshes(Scene& scene, const Document& document);

}  // namespace foredraw::gltf
