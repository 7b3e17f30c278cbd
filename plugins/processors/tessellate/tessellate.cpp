#include "tessellate.h"

#include <foredraw/displaced/corner_normals.h>
#include <foredraw/displaced/interpolated.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>

namespace foredraw {

namespace {

VertexStream vec3_stream(std::string semantic, std::span<const glm::vec3> rows) {
  const auto bytes = std::as_bytes(rows);
  return {std::move(semantic),
          {Component::float32, 3, false, sizeof(glm::vec3)},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// [vertex] the first one at the same position with the same normal: between others there is a crease.
std::vector<std::uint32_t> uncreased(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t v) {
    return std::array{positions[v].x, positions[v].y, positions[v].z, normals[v].x, normals[v].y, normals[v].z};
  };
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    const auto x = std::bit_cast<std::array<std::uint32_t, 6>>(place(a));
    const auto y = std::bit_cast<std::array<std::uint32_t, 6>>(place(b));
    return std::tie(x, a) < std::tie(y, b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

Tessellated tessellate(const DisplacedSurface& surface, std::span<const TessellationLevels> levels,
                       TessellationSpacing spacing, bool keeps_normals) {
  TessellatedMesh mesh = tessellated_mesh(surface.indices, surface.vertices.count, levels, spacing);
  Tessellated made{interpolated(surface.vertices, surface.indices, mesh.samples), {}, {}};
  const std::vector<glm::vec3> corners = decode_vec3(*surface.vertices.find("POSITION"));
  const std::vector<float> by =
      displacements(mesh, surface.indices, surface.places, surface.map, surface.factor, surface.offset);
  const std::vector<glm::vec3> moved = displaced_positions(mesh, surface.indices, corners, surface.directions, by);
  for (VertexStream& stream : made.vertices.base) {
    if (stream.semantic == "NORMAL" && !keeps_normals) {
      std::vector<glm::vec3> normals = decode_vec3(stream);
      const auto flat = decode_vec3(*made.vertices.find("POSITION"));
      replace_by_face_normals(normals, moved, mesh.indices, uncreased(flat, normals));
      stream = vec3_stream("NORMAL", normals);
    }
  }
  for (VertexStream& stream : made.vertices.base) {
    if (stream.semantic == "POSITION") stream = vec3_stream("POSITION", moved);
  }
  for (std::uint32_t t = 0; t < levels.size(); ++t)
    made.source.insert(made.source.end(), tessellation_counts(levels[t], spacing).triangles, t);
  made.indices = std::move(mesh.indices);
  return made;
}

}  // namespace foredraw
