#pragma once
// What a document lists and nobody needs, left out; equal entries, made one. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/layout/private/accessor_store.h>
#include <foredraw/scene/scene.h>

#include <functional>

namespace foredraw::gltf {

/// How one part of a document is tied to an entry of a list that it names by number.
enum class Tie {
  uses,   ///< it is not the same without it
  holds,  ///< the entry hangs below it: children, and roots of scenes
};

/// Calls visit(list, number, tie) for each number by which cameras, images, materials, meshes, nodes, samplers, skins
/// and textures are named, other than in pointers of KHR_animation_pointer and in products. `list`: "materials".
void each_entry_named(Json& json, const std::function<void(const char* list, Json& number, Tie tie)>& visit);

/// Whether each_entry_named() sees all that an extension of that name refers to, pointers and products apart.
bool names_seen_entries(std::string_view extension);

/// Leaves out what holds anyway of nodes' transforms and animations, samplers of animations that no channel uses, and
/// with `joins_equal` those that say the same as an earlier one. Nobody but channels may name samplers.
void shorten_text(Json& json, bool joins_equal);

/// Does to the lists of `json` what the scene asks for, and says what in notes. Meshes and accessors keep their
/// numbers; accessors that nothing names lose their bytes. Nothing changes where an extension is not known so well that
/// nobody is left with a wrong number; where products or animations name nodes and materials, these stay.
void care_for_lists(const Scene& scene, const Document& document, Json& json, AccessorStore& store,
                    Diagnostics& diagnostics);

}  // namespace foredraw::gltf
