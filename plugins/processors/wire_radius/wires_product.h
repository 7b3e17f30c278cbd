#pragma once
// Wires as a product: FOREDRAW_wires, and the shaders that draw them.

#include <foredraw/scene/product_row.h>
#include <foredraw/wires/wires.h>

namespace foredraw {

std::shared_ptr<const ProductRow> wires_product();

}  // namespace foredraw
