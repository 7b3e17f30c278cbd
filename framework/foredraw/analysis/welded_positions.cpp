#include <foredraw/analysis/welded_positions.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace foredraw {

std::vector<std::uint32_t> welded(std::span<const glm::vec3> positions) {
  using Key = std::array<std::uint32_t, 3>;  // bits, which have an order even where a number has none
  const auto bits = [](float number) { return std::bit_cast<std::uint32_t>(number + 0.f); };
  std::vector<std::pair<Key, std::uint32_t>> order;
  order.reserve(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    order.push_back({Key{bits(positions[v].x), bits(positions[v].y), bits(positions[v].z)}, v});
  }
  std::ranges::sort(order);
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [key, vertex] = order[i];
    first[vertex] = i > 0 && key == order[i - 1].first ? first[order[i - 1].second] : vertex;
  }
  return first;
}

}  // namespace foredraw
