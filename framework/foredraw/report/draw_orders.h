#pragma once
// What is told of draws with several orders, and of the tables that choose among them.

#include <foredraw/scene/scene.h>

#include <cstdint>
#include <string>

namespace foredraw {

/// Index buffers in bytes: 2 an index where the vertices allow, else 4.
struct OrderMemory {
  std::size_t orders = 0;                     ///< k
  std::size_t triangles = 0;                  ///< of all draws of the table
  std::uint64_t bytes = 0;                    ///< of all k
  std::uint64_t bytes_for_each_keyframe = 0;  ///< of an order for each keyframe: what the table saves
};
OrderMemory memory_of(const Scene& scene, const OrderTable& table);

/// "3 orders of 12000 triangles: 432 KB; one for each of 45 keyframes would take 6.5 MB".
std::string memory_text(const Scene& scene, const OrderTable& table);

/// "Body, Head".
std::string draws_text(const Scene& scene, const OrderTable& table);

/// The tables and the orders that they choose among, as JSON for engines that read no extension of glTF:
/// docs/draw-orders.md.
std::string draw_orders_json(const Scene& scene);

}  // namespace foredraw
