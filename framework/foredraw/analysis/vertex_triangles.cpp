#include <foredraw/analysis/vertex_triangles.h>

namespace foredraw {

VertexTriangles::VertexTriangles(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                 std::pmr::memory_resource* memory)
    : offsets(vertex_count + 1, 0, memory), triangles(indices.size(), 0, memory) {
  for (std::uint32_t v : indices) ++offsets[v];
  std::uint32_t end = 0;
  for (std::uint32_t& offset : offsets) offset = end += offset;
  // Filled from the back, so that each list comes out in triangle order and offsets end up where lists begin.
  for (std::size_t corner = indices.size(); corner-- > 0;) {
    triangles[--offsets[indices[corner]]] = static_cast<std::uint32_t>(corner / 3);
  }
}

}  // namespace foredraw
