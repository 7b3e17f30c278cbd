#include <foredraw/displaced/shared_edges.h>

#include <algorithm>

namespace foredraw {

std::vector<std::uint32_t> first_edges(std::span<const std::uint32_t> indices, std::uint32_t vertices) {
  const auto edges = static_cast<std::uint32_t>(indices.size());
  const auto smaller = [&](std::uint32_t edge) {
    const EdgeEnds ends = edge_ends(indices, edge);
    return std::min(ends.from, ends.to);
  };
  struct End {
    std::uint32_t vertex = 0, edge = 0;
    bool operator<(const End& other) const {
      return vertex != other.vertex ? vertex < other.vertex : edge < other.edge;
    }
  };
  std::vector<std::uint32_t> begin(std::size_t{vertices} + 1, 0);  // [vertex] of the edges whose smaller end it is
  for (std::uint32_t edge = 0; edge < edges; ++edge) ++begin[smaller(edge) + std::size_t{1}];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<End> ends(edges);  // the larger ones, by the smaller one
  for (std::uint32_t edge = 0; edge < edges; ++edge) {
    const EdgeEnds both = edge_ends(indices, edge);
    ends[begin[std::min(both.from, both.to)]++] = {std::max(both.from, both.to), edge};
  }
  // Each begin is where the next one was.
  std::vector<std::uint32_t> first(edges);
  for (std::size_t v = 0, from = 0; v < vertices; ++v) {
    const std::size_t to = begin[v];
    std::sort(ends.begin() + static_cast<std::ptrdiff_t>(from), ends.begin() + static_cast<std::ptrdiff_t>(to));
    for (std::size_t i = from; i < to; ++i) {
      const bool is_known = i > from && ends[i - 1].vertex == ends[i].vertex;
      first[ends[i].edge] = is_known ? first[ends[i - 1].edge] : ends[i].edge;
    }
    from = to;
  }
  return first;
}

}  // namespace foredraw
