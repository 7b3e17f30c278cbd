#pragma once
#include <foredraw/displaced/seam_heights.h>
#include <foredraw/scene/product_row.h>

namespace foredraw {

/// FOREDRAW_seam_heights, on primitives. Sides follow their triangles.
std::shared_ptr<const ProductRow> seam_heights_product();

}  // namespace foredraw
