#include <foredraw/scene/order_table.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace foredraw {

namespace {

constexpr std::uint32_t most_steps = 1 << 16;

bool rise(const std::vector<float>& times) {
  return !times.empty() && std::ranges::is_sorted(times) &&
         std::ranges::all_of(times, [](float time) { return std::isfinite(time); });
}

}  // namespace

std::span<const OrderTable> order_tables(const Scene& scene) {
  const auto* orders = scene.products.find<DrawOrders>();
  return orders == nullptr ? std::span<const OrderTable>() : orders->tables;
}

std::optional<std::string> mistake_in(const OrderTable& table, std::size_t orders) {
  if (table.draws.empty()) return "names no draw";
  if (std::set(table.draws.begin(), table.draws.end()).size() < table.draws.size()) return "names a draw twice";
  std::set<std::string> names;
  for (const OrderTable::Clip& clip : table.clips) {
    if (!names.insert(clip.name).second) return "has clip '" + clip.name + "' twice";
    if (!rise(clip.times)) return "has clip '" + clip.name + "', whose times do not rise";
  }
  const auto [fewest, most] = std::minmax(table.theta_steps, table.phi_steps);
  if (fewest == 0 || most > most_steps) {
    return "has " + std::to_string(table.theta_steps) + " steps of theta and " + std::to_string(table.phi_steps) +
           " of phi, but must have 1 to " + std::to_string(most_steps);
  }
  if (table.order.size() != table.cells()) {
    return "has " + std::to_string(table.order.size()) + " cells, but must have " + std::to_string(table.cells());
  }
  const std::size_t highest = *std::ranges::max_element(table.order);
  if (highest >= orders) {
    return "names order " + std::to_string(highest) + " of " + std::to_string(orders) + ", counted from 0";
  }
  return std::nullopt;
}

}  // namespace foredraw
