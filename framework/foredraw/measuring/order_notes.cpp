#include <foredraw/measuring/order_notes.h>

#include <foredraw/draw_orders/order_memory.h>

#include <algorithm>

namespace foredraw {

void note_order_memory(const SubjectView& view, const SubjectOrders& answer, const Run& run) {
  const OrderTable& table = answer.table;
  if (std::ranges::none_of(table.order, [](std::uint8_t order) { return order > 0; })) return;
  OrderMemory memory;
  for (std::size_t i = 0; i < table.draws.size(); ++i) {
    add_memory(memory, view.scene.draws[table.draws[i]].levels[0], answer.orders[i].size(), table.keyframes());
  }
  run.note("memory", memory_text(memory, table.keyframes()));
}

}  // namespace foredraw
