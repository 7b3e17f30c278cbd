#pragma once
// FOREDRAW_merge_instances: draws merged into few, beside the nodes that show the same.
// docs/merge-instances.md tells what the members mean. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/private/accessor_store.h>
#include <foredraw/io/gltf/private/source.h>

#include <set>

namespace foredraw::gltf {

inline constexpr const char* merge_instances = "FOREDRAW_merge_instances";

/// Puts a document's merged draws into its scene. Where they do not hold, a warning says why, and all of them are taken out
/// of the document: the nodes show the same.
void read_merged_instances(Document& document, Scene& scene, Diagnostics& diagnostics);

/// Puts the scene's merged draws into `json`, once its meshes are there. Accessors of primitives whose vertices are a part
/// of merged ones become a part of theirs, so that no vertex is written twice.
void patch_merged_instances(const Scene& scene, const Source& source, Json& json, AccessorStore& store);

/// Accessors that merged draws name; of JSON in which anything may be wrong, too.
std::set<std::size_t> used_by_merged(const Json& json);

/// Those that they name as vertices.
std::set<std::size_t> merged_vertex_data(const Json& json);

}  // namespace foredraw::gltf
