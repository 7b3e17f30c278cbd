#pragma once
// The row of what geomorphs makes: the ancestors of vertices, level by level.

#include <foredraw/collapses/geomorphs.h>
#include <foredraw/scene/product_row.h>

namespace foredraw {

/// How Geomorphs are read, written, proved and told. Proved is that triangles end as those of the next level: a
/// renderer that has moved all vertices to their ancestors may draw the next level in their place, and no pixel
/// changes.
std::shared_ptr<const ProductRow> geomorph_product();

}  // namespace foredraw
