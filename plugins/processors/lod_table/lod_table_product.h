#pragma once
// The row of what lod-table makes: how a LodTable is read, written, followed, checked and told.

#include <foredraw/frames/lod_table.h>
#include <foredraw/scene/product_row.h>

#include <variant>

namespace foredraw {

std::shared_ptr<const ProductRow> lod_table_product();

/// FOREDRAW_lod_table, on the file and on primitives, as a table, or what is wrong with it as the rest of a sentence.
std::variant<LodTable, std::string> read_lod_table(ExtensionReader& from, const Scene& scene);
void write_lod_table(const LodTable& table, ExtensionWriter& to);

/// The table for engines: static const arrays for C99 and C++ in the types of runtime/lod_table.h. `stem`: what their
/// names begin with, such as "rock" of rock.h.
std::string lod_table_header(const LodTable& table, const Scene& scene, const std::string& stem);
/// The same as JSON, one object for each way.
ExtensionValue lod_table_value(const LodTable& table, const Scene& scene);

}  // namespace foredraw
