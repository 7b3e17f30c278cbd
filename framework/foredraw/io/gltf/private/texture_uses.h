#pragma once
// The textures of materials, wherever they are looked up. Private to io.

#include <foredraw/io/gltf/private/document.h>

namespace foredraw::gltf {

/// Calls visit(name, use) for each use of a texture ("baseColorTexture") in a material, those in extensions too. What
/// is in extras is none.
template <class AnyJson, class Visit>
void each_texture_use(AnyJson& holder, const Visit& visit) {
  if (!holder.is_object()) return;
  for (auto&& [name, part] : holder.items()) {
    if (name == "extras" || !part.is_object()) continue;
    if (part.contains("index")) visit(name, part);
    each_texture_use(part, visit);
  }
}

}  // namespace foredraw::gltf
