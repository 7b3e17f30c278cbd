#include "weld.h"

#include <foredraw/analysis/equal_vertices.h>
#include <foredraw/scene/draw.h>

namespace foredraw {

Weld weld(const VertexStreams& vertices, std::span<const std::span<const std::uint32_t>> index_streams,
          const WeldOptions& options) {
  std::vector<bool> used(vertices.count, options.keep_unused);
  for (const auto& indices : index_streams) {
    for (std::uint32_t v : indices) used[v] = true;
  }

  const std::vector<std::uint32_t> first = first_of_equals(vertices);
  std::vector<std::uint32_t> kept(vertices.count, no_vertex);  // [first of equals] the new vertex for all of them
  Weld result;
  result.destination.assign(vertices.count, no_vertex);
  for (std::uint32_t v = 0; v < vertices.count; ++v) {
    if (!used[v]) {
      ++result.unused;
      continue;
    }
    std::uint32_t& vertex = kept[first[v]];
    if (vertex == no_vertex) {
      vertex = result.count++;
    } else {
      ++result.merged;
    }
    result.destination[v] = vertex;
  }
  return result;
}

}  // namespace foredraw
