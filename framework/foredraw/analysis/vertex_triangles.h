#pragma once
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw {

/// Which triangles use a vertex, in triangle order; a triangle that uses it twice is there twice. Three linear passes.
struct VertexTriangles {
  std::pmr::vector<std::uint32_t> offsets;    ///< vertices + 1
  std::pmr::vector<std::uint32_t> triangles;  ///< those of vertex v: [offsets[v], offsets[v + 1])

  /// Every index must be below `vertex_count`.
  VertexTriangles(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                  std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return std::span(triangles).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
};

}  // namespace foredraw
