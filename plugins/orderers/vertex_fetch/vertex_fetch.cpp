#include "vertex_fetch.h"

namespace foredraw {

std::vector<std::uint32_t> vertex_fetch(std::span<const std::span<const std::uint32_t>> index_streams,
                                        std::size_t vertex_count) {
  std::vector<std::uint32_t> order;
  order.reserve(vertex_count);
  std::vector<bool> placed(vertex_count, false);
  const auto place = [&](std::uint32_t v) {
    if (placed[v]) return;
    placed[v] = true;
    order.push_back(v);
  };
  for (const auto& indices : index_streams) {
    for (std::uint32_t v : indices) place(v);
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) place(v);
  return order;
}

}  // namespace foredraw
