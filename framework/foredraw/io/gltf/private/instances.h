#pragma once
// EXT_mesh_gpu_instancing, read and written. Private to io.

#include <foredraw/io/gltf/layout/private/accessor_store.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

/// Gives every node the instances that its extension places. The gate has looked at them.
void add_instances(Scene& scene, const Document& document);

/// Puts what differs from as many instances that there were into the extension's attributes; other attributes stay.
/// Accessors that these named join `left`.
void patch_instancing(std::span<const Transform> now, std::span<const Transform> was, Json& attributes,
                      AccessorStore& store, std::set<std::size_t>& left);

/// The extension's object that places these, of which there is one at least.
Json instancing_of(std::span<const Transform> instances, AccessorStore& store);

}  // namespace foredraw::gltf
