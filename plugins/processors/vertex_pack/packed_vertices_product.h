#pragma once
// The row of what vertex-pack makes: how PackedVertices are read, written, followed, proved and told.

#include <foredraw/packing/packed_vertices.h>
#include <foredraw/scene/product_row.h>

#include <string>
#include <variant>

namespace foredraw {

/// Proved is that rows keep what their layout promises, of every vertex of the plain streams.
std::shared_ptr<const ProductRow> packed_vertices_product();

/// FOREDRAW_packed_vertices on primitives, or what is wrong with it as the rest of a sentence.
std::variant<PackedVertices, std::string> read_packed_vertices(ExtensionReader& from, const Scene& scene);
void write_packed_vertices(const PackedVertices& all, ExtensionWriter& to);

/// The layouts for engines: static const data for C99 and C++ in the types of runtime/packed_vertex.h. `stem`: what
/// their names begin with, such as "rock" of rock.h.
std::string packed_vertices_header(const PackedVertices& all, const Scene& scene, const std::string& stem);
/// The same as functions of a shader, `extension` ".glsl" or ".hlsl": PACKED_LAYOUT chooses the layout.
std::string packed_vertices_shader(const PackedVertices& all, const Scene& scene, std::string_view extension);

}  // namespace foredraw
