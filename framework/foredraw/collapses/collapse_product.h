#pragma once
#include <foredraw/scene/product_row.h>

namespace foredraw {

/// How CollapseSequences are read, written, checked and told.
std::shared_ptr<const ProductRow> collapse_product();

}  // namespace foredraw
