#pragma once
// From a scene back to a document. Private to io.

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/gltf/layout/private/accessor_store.h>
#include <foredraw/io/gltf/private/source.h>
#include <foredraw/platform/files.h>

#include <functional>
#include <set>

namespace foredraw::gltf {

/// A document ready to be packed: its JSON, and the bytes of its buffers.
struct Written {
  Json json;
  LaidOut laid_out;
  std::vector<Chunk> further_chunks;
  bool compact = false;  ///< text without line breaks, as it came
  bool changed = true;   ///< false: the file can stay as it was, and nothing was laid out
};

/// The source's document with the scene's changes in it, for a target. With `may_stay`, the file itself will do where
/// nothing changed. Products are written by the rows of `as`. nullopt, with an error, where a change can not be said.
std::optional<Written> patched(const Scene& scene, const Source& source, const std::filesystem::path& target,
                               bool may_stay, const GltfOutput& as, Diagnostics& diagnostics);

/// Puts the changed draws into `json` and `store`. False, with an error, where one can not be said.
bool patch_meshes(const Scene& scene, const Source& source, const ProductRows& rows, Json& json, AccessorStore& store,
                  Diagnostics& diagnostics);

/// glTF has no empty primitive: one that covers nothing stands for it, three times vertex 0.
std::span<const std::uint32_t> never_empty(std::span<const std::uint32_t> triangles);

/// Indices as narrow as `was`, or as wide as the numbers need: the greatest number of a type is kept free.
Content index_content(std::span<const std::uint32_t> indices, Component was);

/// Nodes, skins, animations, materials and images: those that were added, and what may change of the old ones.
bool patch_structure(const Scene& scene, const Source& source, Json& json, AccessorStore& store,
                     Diagnostics& diagnostics);

/// A change that a document can not say, and the place of it.
struct Refusal {
  std::string inside;
  std::string why;
};

/// What differs of the nodes that there were: their places, names and weights, meshes that are gone, children that were
/// added, their instances, and the sequence of children and roots. Accessors that instances named join `left`.
std::optional<Refusal> patch_nodes(const Scene& scene, const Scene& was, Json& json, AccessorStore& store,
                                   std::set<std::size_t>& left);

/// Nodes behind the `old` ones, which are there. patch_nodes() has looked at them.
void add_nodes(const Scene& scene, std::size_t old, Json& json, AccessorStore& store);

/// The keys of animations that changed, channels that are gone, and animations that were added. Of those that there
/// were, channels keep their sequence and what they move, and one stays; weights may move a child that was added to the
/// node that they moved. Accessors that samplers named join `left`.
std::optional<Refusal> patch_animations(const Scene& scene, const Scene& was, Json& json, AccessorStore& store,
                                        std::set<std::size_t>& left);

/// Releases those of the accessors that nothing in `json` names any more. An extension that we do not know may mean any
/// number that it holds.
void release_unnamed(std::set<std::size_t> accessors, const Document& document, Json& json, AccessorStore& store);

/// The list of that name, which is made where there is none: what the library makes of null can not be freed where
/// memory runs out in it.
Json& list_in(Json& holder, const char* name);

/// JSON has no words for other numbers, and the reader refuses them in accessors.
bool all_finite(std::span<const float> values);

/// What differs from `was`: of material `number`, which the document has. Textures that are not there are listed.
void put_material(std::size_t number, const Material& now, const Material& was, Json& document);

/// All numbers by which primitives, skins, animations and instancing name accessors: who else may are products and
/// extensions that we do not know.
void each_accessor_named(Json& json, const std::function<void(Json& number)>& visit);

/// Accessors that primitives name as attributes, targets or indices.
std::set<std::size_t> used_by_primitives(const Json& json);

/// Accessors that somebody else may refer to, products apart. An extension that we do not know may mean any number
/// that it holds.
std::set<std::size_t> used_elsewhere(const Document& document);

/// Numbers that extensions which we do not know hold: any may mean an accessor, a view or whatever else.
std::set<std::size_t> named_by_unknown_extensions(const Document& document);

/// Images by uri still mean the same files when the document lies in another folder.
void relocate_images(Json& json, const Document& document, const std::filesystem::path& target,
                     Diagnostics& diagnostics);

/// Whether a target's name asks for a .glb.
bool is_glb(const std::filesystem::path& target);

/// out.bin beside out.gltf.
std::filesystem::path buffer_beside(const std::filesystem::path& target);

/// out.fallback.bin beside out.gltf, then out.fallback1.bin, as other tools call them; out.glb.fallback.bin beside
/// out.glb, so that two scenes of one name have files of their own.
std::filesystem::path fallback_beside(const std::filesystem::path& target, std::size_t i);

/// The files of a document. nullopt, with an error, where a GLB would be longer than its header can say.
std::optional<std::vector<OutputFile>> packed(Written written, const std::filesystem::path& target,
                                              Diagnostics& diagnostics);

}  // namespace foredraw::gltf
