#pragma once
// FOREDRAW_second_depth: in files, and under later stages.

#include <foredraw/scene/product_row.h>

namespace foredraw {

std::shared_ptr<const ProductRow> second_depth_product();

}  // namespace foredraw
