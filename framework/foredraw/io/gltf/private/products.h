#pragma once
// Extensions of products, between the JSON of a document and their rows. Private to io.

#include <foredraw/io/gltf/layout/private/accessor_store.h>
#include <foredraw/io/gltf/private/source.h>
#include <foredraw/scene/product_row.h>

#include <set>

namespace foredraw::gltf {

/// Takes an extension that only Foredraw reads out of a document, which need not have been checked: what can not be
/// believed must not be written again, and costs nothing else. The writer may then drop the accessors that it named.
void take_out(Document& document, const ProductCard& card);

/// The one word of that: a warning, or an error where the reading is strict.
void tell_taken_out(const std::string& file, const ProductCard& card, const std::string& why, bool strict,
                    Diagnostics& diagnostics);

/// Puts a document's products into its scene. One that does not hold is taken out of the document. False, with an error
/// for each, where that must not be.
bool read_products(Document& document, Scene& scene, bool strict, Diagnostics& diagnostics);

/// Puts the scene's products into `json`, once its meshes are there. What the file says of the same products stays.
/// `of_levels`: the scene with the levels of its draws, which `scene` has as draws of their own behind all others.
void patch_products(const Scene& scene, const Scene& of_levels, const Source& source, const ProductRows& rows,
                    Json& json, AccessorStore& store, Diagnostics& diagnostics);

/// Accessors that the extension names; of JSON in which anything may be wrong, too.
std::set<std::size_t> used_by_product(const Json& json, const ProductCard& card);
std::set<std::size_t> used_by_products(const Json& json, const ProductRows& rows);

/// Those of `gone` that are in the document and that nobody names; of products, these are asked.
std::set<std::size_t> freed(const std::set<std::size_t>& gone, const ProductRows& others, const Document& document);

}  // namespace foredraw::gltf
