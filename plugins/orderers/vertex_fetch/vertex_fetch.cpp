#include "vertex_fetch.h"

namespace foredraw {

std::vector<std::uint32_t> vertex_fetch(std::span<const std::span<const std::uint32_t>> index_streams,
                                        std::size_t vertex_count) {
  std::vector<std::uint32_t> order(vertex_count + 1);  // one more, for each is written before it is known to be new
  std::vector<char> placed(vertex_count, 0);
  std::size_t count = 0;
  const auto place = [&](std::uint32_t v) {
    order[count] = v;
    count += placed[v] == 0;
    placed[v] = 1;
  };
  for (const auto& indices : index_streams) {
    for (std::uint32_t v : indices) place(v);
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) place(v);
  order.pop_back();
  return order;
}

}  // namespace foredraw
