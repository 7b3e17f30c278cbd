#include <foredraw/viewing/drawn_orders.h>

#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/order_lookup.h>
#include <foredraw/viewing/pose_set.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace foredraw {

namespace {

/// A table that draws some of a subject's parts, in one pose.
struct PosedTable {
  OrderLookup lookup;
  std::span<const std::uint8_t> cells;  ///< none: order 0
  std::vector<std::size_t> parts;
};

std::vector<PosedTable> tables_of(const Scene& scene, const Subject& subject, const Pose& pose) {
  std::vector<PosedTable> tables;
  if (order_tables(scene).empty()) return tables;
  const std::vector<std::string> names = clip_names(scene);
  for (const OrderTable& table : order_tables(scene)) {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < subject.parts.size(); ++i) {
      if (std::ranges::find(table.draws, subject.parts[i].draw) != table.draws.end()) parts.push_back(i);
    }
    if (parts.empty()) continue;
    tables.push_back({OrderLookup(table, names), {}, std::move(parts)});
    tables.back().cells = tables.back().lookup.cells_in(pose);
  }
  return tables;
}

}  // namespace

std::vector<ViewsOfOrders> views_by_orders(const Scene& scene, const Subject& subject, const Pose& pose,
                                           std::span<const View> views) {
  const std::vector<PosedTable> tables = tables_of(scene, subject, pose);
  std::vector<std::uint32_t> orders(subject.parts.size(), 0);
  if (tables.empty()) {
    std::vector<std::size_t> all(views.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return {{std::move(orders), std::move(all)}};
  }
  std::map<std::vector<std::uint32_t>, std::vector<std::size_t>> by_orders;
  for (std::size_t view = 0; view < views.size(); ++view) {
    for (const PosedTable& table : tables) {
      if (table.cells.empty()) continue;
      const std::uint32_t order = table.cells[table.lookup.cell_of(views[view].direction)];
      for (const std::size_t part : table.parts) orders[part] = order;
    }
    by_orders[orders].push_back(view);
  }
  std::vector<ViewsOfOrders> result;
  for (auto& [alike, numbers] : by_orders) result.push_back({alike, std::move(numbers)});
  return result;
}

Views chosen(const Views& views, std::span<const std::size_t> numbers) {
  Views some{{}, views.size};
  for (const std::size_t number : numbers) some.views.push_back(views.views[number]);
  return some;
}

void set_orders(SubjectGeometry& drawn, const Scene& scene, const Subject& subject,
                std::span<const std::uint32_t> orders) {
  for (std::size_t part = 0; part < drawn.parts.size(); ++part) {
    if (drawn.parts[part].indices.empty()) continue;  // not drawn
    drawn.parts[part].indices = scene.draws[subject.parts[part].draw].full().orders.at(orders[part]).indices.view();
  }
}

Stamp orders_stamp(const Scene& scene, const Subject& subject, const Pose& pose) {
  std::vector<Stamp> stamps;
  for (const PosedTable& table : tables_of(scene, subject, pose)) stamps.push_back(content_hash(table.cells));
  return combine(stamps);
}

}  // namespace foredraw
