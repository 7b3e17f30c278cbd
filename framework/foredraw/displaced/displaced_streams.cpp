#include <foredraw/displaced/displaced_streams.h>

#include <foredraw/displaced/corner_normals.h>
#include <foredraw/displaced/interpolated.h>
#include <foredraw/scene/triangle_draw.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>

namespace foredraw {

namespace {

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

VertexStreams displaced_streams(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                                std::span<const glm::vec3> directions, const TessellatedMesh& mesh,
                                std::span<const float> displacements, bool keeps_normals) {
  VertexStreams made = interpolated(vertices, indices, mesh.samples);
  const std::vector<glm::vec3> flat = decode_vec3(*made.find("POSITION"));
  const std::vector<glm::vec3> moved =
      displaced_positions(mesh, indices, decode_vec3(*vertices.find("POSITION")), directions, displacements);
  for (VertexStream& stream : made.base) {
    if (stream.semantic == "POSITION") stream = float_stream("POSITION", moved);
    if (stream.semantic != "NORMAL" || keeps_normals) continue;
    std::vector<glm::vec3> normals = decode_vec3(stream);
    replace_by_face_normals(normals, moved, mesh.indices, uncreased(flat, normals));
    stream = float_stream("NORMAL", normals);
  }
  return made;
}

}  // namespace foredraw
