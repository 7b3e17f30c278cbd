#pragma once
// FOREDRAW_draw_orders: several index buffers for a primitive, and the tables that choose among them.
// docs/draw-orders.md tells what the members mean. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/private/accessor_store.h>
#include <foredraw/io/gltf/private/source.h>

#include <set>

namespace foredraw::gltf {

inline constexpr const char* draw_orders = "FOREDRAW_draw_orders";

/// Puts a document's orders and tables into its scene. Where they do not hold, a warning says why, and all of them are
/// taken out of the document: an order that draws something else than the primitive must not be written again.
void read_draw_orders(Document& document, Scene& scene, Diagnostics& diagnostics);

/// Puts the scene's tables into `json`, once its meshes are there.
void patch_order_tables(const Scene& scene, const Source& source, Json& json, AccessorStore& store,
                        Diagnostics& diagnostics);

/// Accessors that primitives name as further orders.
std::set<std::size_t> used_by_orders(const Json& json);

/// Accessors that tables name.
std::set<std::size_t> used_by_tables(const Json& json);

/// Whether a primitive or the file has the extension.
bool has_draw_orders(const Json& json);

/// Takes it out everywhere.
void take_draw_orders(Json& json);

}  // namespace foredraw::gltf
