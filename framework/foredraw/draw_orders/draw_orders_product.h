#pragma once
// Several orders of a draw and the tables that choose among them, as a product: FOREDRAW_draw_orders.
// docs/reference/draw-orders.md tells what the members mean.

#include <foredraw/scene/order_table.h>
#include <foredraw/scene/product_row.h>

namespace foredraw {

/// For plugins whose orderers answer with several orders. The orders themselves stand in the draws' levels; the product
/// is the tables.
std::shared_ptr<const ProductRow> draw_orders_product();

/// Puts orders and tables into the scene, or answers with what is wrong.
std::string read_draw_orders(ExtensionReader& from, Scene& scene);
void write_draw_orders(const Scene& scene, ExtensionWriter& to);

/// The tables and the orders that they choose among, for engines that read no extension of glTF.
ExtensionValue draw_orders_value(const Scene& scene);

}  // namespace foredraw
