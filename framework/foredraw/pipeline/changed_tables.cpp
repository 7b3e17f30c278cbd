#include <foredraw/pipeline/changed_tables.h>

#include <foredraw/scene/levels.h>

#include <algorithm>
#include <utility>

namespace foredraw {

ChangedTables::ChangedTables(Scene& scene) : scene_(scene) {
  const auto before = order_tables(scene);
  tables_.assign(before.begin(), before.end());
}

void ChangedTables::put(OrderedSubject answer, std::size_t level) {
  for (auto& [id, draw] : answer.draws) {
    if (level == 0) forget_tables_of(id);
    if (level > 0) draw.full().orders.resize(1);
    put_level(scene_.draws[id], level, std::move(draw));
  }
  const bool has_choice = std::ranges::any_of(answer.table.order, [](std::uint8_t order) { return order > 0; });
  if (level == 0 && has_choice) tables_.push_back(std::move(answer.table));
}

/// A draw that is ordered anew has no orders of the old table, and without its table other draws' are of no use.
void ChangedTables::forget_tables_of(DrawId id) {
  std::erase_if(tables_, [&](const OrderTable& table) {
    if (std::ranges::find(table.draws, id) == table.draws.end()) return false;
    for (const DrawId other : table.draws) scene_.draws[other].full().orders.resize(1);
    return true;
  });
}

void ChangedTables::settle(StageProducts& products) {
  if (tables_.empty()) {
    scene_.products.erase(DrawOrders::product);
  } else {
    scene_.products.set(DrawOrders{std::move(tables_)});
  }
  products.made(DrawOrders::product);
}

}  // namespace foredraw
