#pragma once
// The row of what tessellation-levels makes: how levels are read, written, proved, followed and told.

#include <foredraw/displaced/tessellation_levels.h>
#include <foredraw/scene/product_row.h>

#include <memory>
#include <string>
#include <vector>

namespace foredraw {

/// FOREDRAW_tessellation_levels on primitives. Proved is that triangles which share an edge agree on its level, within
/// a mesh also where they are in different draws: no crack opens.
std::shared_ptr<const ProductRow> tessellation_levels_product();

/// Where ranges of triangles begin that have a range of displacements each: the stream's clusters, or else every 128.
std::vector<std::uint32_t> range_begins(const IndexStream& stream);

/// From a primitive's extension, of which nothing is to be trusted. What is wrong, as the rest of a sentence; empty:
/// nothing.
std::string read_tessellation(ExtensionReader& from, const ExtensionValue& value, DrawTessellation& to);
/// How it differs from its draw, which is there; the same.
std::string tessellation_difference(const DrawTessellation& of, const Scene& scene);
/// Whether triangles that share an edge give it different levels; the same.
std::string tessellation_disagreement(const StoredTessellations& stored, const Scene& scene);

}  // namespace foredraw
