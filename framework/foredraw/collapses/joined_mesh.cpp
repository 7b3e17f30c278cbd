#include <foredraw/collapses/joined_mesh.h>

#include <algorithm>

namespace foredraw {

std::optional<JoinedMesh> joined_mesh(const Scene& scene, std::span<const DrawId> draws, Analyses& analyses) {
  constexpr std::size_t most = std::size_t{1} << 31;
  JoinedMesh mesh;
  for (const DrawId id : draws) {
    if (id >= scene.draws.size() || scene.draws[id].topology != Topology::triangles) return std::nullopt;
    const Level& level = scene.draws[id].full();
    auto known = std::ranges::find(mesh.streams, level.vertices);
    if (known == mesh.streams.end()) {
      mesh.first_vertex.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      const auto positions = positions_of(analyses, *level.vertices);
      if (mesh.positions.size() + level.vertices->count > most) return std::nullopt;
      mesh.positions.insert(mesh.positions.end(), positions->values.begin(), positions->values.end());
      mesh.positions.resize(mesh.first_vertex.back() + level.vertices->count);
      mesh.part.resize(mesh.positions.size(), static_cast<std::uint32_t>(mesh.streams.size()));
      mesh.streams.push_back(level.vertices);
      known = mesh.streams.end() - 1;
    }
    mesh.stream_of.push_back(static_cast<std::uint32_t>(known - mesh.streams.begin()));
    mesh.first_index.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
    const auto indices = level.stream().indices.view();
    if (mesh.indices.size() + indices.size() > most) return std::nullopt;
    const std::uint32_t first = mesh.first_vertex[mesh.stream_of.back()];
    for (const std::uint32_t index : indices) mesh.indices.push_back(first + index);
  }
  mesh.first_index.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
  mesh.first_vertex.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
  return mesh;
}

}  // namespace foredraw
