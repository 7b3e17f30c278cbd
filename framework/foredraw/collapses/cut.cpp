#include <foredraw/collapses/cut.h>
#include <foredraw/collapses/level_vertices.h>

namespace foredraw {

std::vector<CutDraw> cut(const CollapseSequence& sequence, std::size_t collapses, const JoinedMesh& mesh) {
  const Collapsed after = collapsed(sequence, collapses, mesh.positions, mesh.indices);
  std::vector<LevelVertices> streams;
  for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
    streams.push_back(level_vertices(sequence, collapses, after, mesh, s));
  }
  std::vector<CutDraw> draws;
  std::size_t t = 0;
  for (std::size_t d = 0; d < mesh.stream_of.size(); ++d) {
    const std::uint32_t s = mesh.stream_of[d];
    std::vector<std::uint32_t> indices;
    for (; t < after.origin.size() && 3 * after.origin[t] < mesh.first_index[d + 1]; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        indices.push_back(streams[s].number[after.indices[3 * t + k] - mesh.first_vertex[s]]);
      }
    }
    draws.push_back({streams[s].vertices, Shared<std::uint32_t>(std::move(indices))});
  }
  return draws;
}

}  // namespace foredraw
