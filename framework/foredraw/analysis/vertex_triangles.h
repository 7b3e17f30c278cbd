#pragma once
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw {

/// Which triangles use a vertex, in triangle order; a triangle that uses it twice is there twice. Three linear passes.
/// Wholly in this header, so that techniques which are the standard library alone may use it.
struct VertexTriangles {
  std::pmr::vector<std::uint32_t> offsets;    ///< vertices + 1
  std::pmr::vector<std::uint32_t> triangles;  ///< those of vertex v: [offsets[v], offsets[v + 1])

  /// Every index must be below `vertex_count`.
  VertexTriangles(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                  std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : offsets(vertex_count + 1, 0, memory), triangles(indices.size(), 0, memory) {
    for (std::uint32_t v : indices) ++offsets[v];
    std::uint32_t end = 0;
    for (std::uint32_t& offset : offsets) offset = end += offset;
    // Filled from the back, so that each list comes out in triangle order and offsets end up where lists begin.
    for (std::size_t corner = indices.size(); corner-- > 0;) {
      triangles[--offsets[indices[corner]]] = static_cast<std::uint32_t>(corner / 3);
    }
  }

  std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return std::span(triangles).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
};

}  // namespace foredraw
