#pragma once
// What several orders of a subject take.

#include <foredraw/scene/order_table.h>

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
std::string memory_text(const OrderMemory& memory, std::size_t keyframes);

}  // namespace foredraw
