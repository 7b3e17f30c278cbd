#pragma once
// The row of what displacement-bake makes: the heights of cages.

#include <foredraw/displaced/baked_heights.h>
#include <foredraw/scene/product_row.h>

namespace foredraw {

/// How BakedHeights are read, written, checked and told, and how they follow triangles and vertices to their new
/// numbers.
std::shared_ptr<const ProductRow> baked_heights_product();

}  // namespace foredraw
