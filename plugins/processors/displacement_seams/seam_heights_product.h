#pragma once
#include <foredraw/scene/product_row.h>
#include <foredraw/scene/seam_heights.h>

namespace foredraw {

/// FOREDRAW_seam_heights, on primitives. Sides follow their triangles.
std::shared_ptr<const ProductRow> seam_heights_product();

}  // namespace foredraw
