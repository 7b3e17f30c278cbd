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

bool is_permutation(std::span<const std::uint16_t> sequence) {
  std::vector<bool> is_there(sequence.size(), false);
  for (const std::uint16_t part : sequence) {
    if (part >= sequence.size() || is_there[part]) return false;
    is_there[part] = true;
  }
  return true;
}

std::optional<std::string> mistake_in_sequences(const OrderTable& table, std::size_t orders) {
  constexpr std::size_t most_parts = 1 << 16;
  const std::size_t parts = table.parts.size();
  if (parts > most_parts) {
    return "has sequences of " + std::to_string(parts) + " parts, but may have " + std::to_string(most_parts);
  }
  std::set<std::pair<DrawId, std::optional<NodeId>>> named;
  for (const auto& [draw, node] : table.parts) {
    if (!named.emplace(draw, node).second) return "names a part twice";
  }
  if (table.sequences.size() != orders * parts) {
    return "has sequences of " + std::to_string(table.sequences.size()) + " parts in all, but must have " +
           std::to_string(orders) + " of " + std::to_string(parts) + " parts each";
  }
  for (std::size_t order = 0; parts > 0 && order < orders; ++order) {
    if (!is_permutation(table.sequence(order))) {
      return "has a sequence for order " + std::to_string(order) + " that does not name every part once";
    }
  }
  return std::nullopt;
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
  return mistake_in_sequences(table, orders);
}

}  // namespace foredraw
