#pragma once
// Mesh files from texts, and what they draw.

#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/scene/vertex_groups.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace foredraw::testing {

struct MeshRead {
  std::optional<Scene> scene;
  Diagnostics diagnostics;

  /// The one error, as people see it; empty where there is none.
  std::string error() const {
    std::string text;
    for (const Diagnostic& d : diagnostics.all()) {
      if (d.severity == Severity::error) text += to_text(d);
    }
    return text.substr(0, text.find("\n    hint"));
  }
  /// The codes of warnings and notes, in order.
  std::string told() const {
    std::string text;
    for (const Diagnostic& d : diagnostics.all()) {
      if (d.severity != Severity::error) text += (text.empty() ? "" : " ") + d.code;
    }
    return text;
  }
};

inline MeshRead read_mesh(MeshKind kind, std::string_view text, const std::filesystem::path& folder = {},
                          const SceneInput& how = {}) {
  MeshRead read;
  read.scene = read_mesh_file(std::as_bytes(std::span(text)), kind, "input" + std::string(extension_of(kind)), folder,
                              read.diagnostics, how);
  return read;
}

/// Each triangle as its mesh, its material, and its corners' bytes over all attributes; sorted, so that neither order
/// nor numbers count.
inline std::vector<std::string> drawn(const Scene& scene) {
  std::vector<std::string> triangles;
  for (const Mesh& mesh : scene.meshes) {
    for (DrawId id : mesh.draws) {
      const Draw& draw = scene.draws[id];
      if (draw.topology != Topology::triangles) continue;
      const Material* material = scene.material_of(draw);
      const auto indices = draw.levels[0].orders[0].indices.view();
      for (std::size_t i = 0; i < indices.size(); ++i) {
        if (i % 3 == 0) triangles.push_back(mesh.name + '|' + (material == nullptr ? "" : material->name) + '|');
        for (const VertexStream& stream : draw.levels[0].vertices->base) {
          const auto row =
              stream.bytes.view().subspan(std::size_t{indices[i]} * stream.format.bytes, stream.format.bytes);
          triangles.back().append(reinterpret_cast<const char*>(row.data()), row.size());
        }
      }
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// The scene with the triangles and the vertices of every draw in reverse, as orderers would leave it.
inline Scene reversed(Scene scene) {
  for (Draw& draw : scene.draws) {
    if (draw.topology != Topology::triangles) continue;
    IndexOrder order(draw.levels[0].orders[0].triangle_count());
    std::iota(order.rbegin(), order.rend(), 0u);
    draw = with_triangle_order(draw, order);
  }
  for (const VertexGroup& group : vertex_groups(scene)) {
    if (scene.draws[group.users.front().draw].topology != Topology::triangles) continue;
    std::vector<std::uint32_t> destination(group.vertices->count);
    std::iota(destination.rbegin(), destination.rend(), 0u);
    move_vertices(scene, group, destination, group.vertices->count);
  }
  return scene;
}

inline std::string text_of(const OutputFile& file) {
  return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

}  // namespace foredraw::testing
