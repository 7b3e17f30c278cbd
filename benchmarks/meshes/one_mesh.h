#pragma once
// What benchmarks of one mesh do alike: reading it from a file.

#include <benchmarks/timing.h>

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/io/scene_file.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::bench {

/// All triangles of the file, in the draws' own spaces.
inline JoinedMesh read_joined(const std::string& path) {
  Diagnostics diagnostics;
  const auto file = read_scene(path, diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  std::vector<DrawId> draws;
  for (DrawId id = 0; id < file->scene.draws.size(); ++id) {
    if (file->scene.draws[id].topology == Topology::triangles) draws.push_back(id);
  }
  Analyses analyses;
  return joined_mesh(file->scene, draws, analyses).value();
}

/// One vertex a place, in the sequence in which triangles name them; triangles with two corners at one are gone.
struct WeldedMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  std::size_t triangles() const { return indices.size() / 3; }
};

inline WeldedMesh welded_mesh(const JoinedMesh& joined) {
  const std::vector<std::uint32_t> first = welded(joined.positions);
  WeldedMesh mesh;
  std::vector<std::uint32_t> number(first.size(), ~0u);
  for (std::size_t i = 0; i + 2 < joined.indices.size(); i += 3) {
    const std::array corners{first[joined.indices[i]], first[joined.indices[i + 1]], first[joined.indices[i + 2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (const std::uint32_t v : corners) {
      if (number[v] == ~0u) {
        number[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(joined.positions[v]);
      }
      mesh.indices.push_back(number[v]);
    }
  }
  return mesh;
}

}  // namespace foredraw::bench
