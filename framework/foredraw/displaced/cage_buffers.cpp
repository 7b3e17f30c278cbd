#include <foredraw/displaced/cage_buffers.h>

#include <foredraw/scene/skin_weights.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

std::vector<foredraw_cage_vertex> cage_vertices(std::span<const glm::vec3> positions,
                                                std::span<const glm::vec3> directions,
                                                std::span<const std::array<std::int32_t, 2>> places) {
  if (directions.size() != positions.size() || places.size() != positions.size()) {
    throw std::invalid_argument("a cage has as many directions and places as positions");
  }
  std::vector<foredraw_cage_vertex> vertices;
  vertices.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const glm::vec3 &p = positions[v], &d = directions[v];
    vertices.push_back({{p.x, p.y, p.z}, places[v][0], {d.x, d.y, d.z}, places[v][1]});
  }
  return vertices;
}

std::vector<foredraw_cage_skin> cage_skin(const VertexStreams& vertices, std::uint32_t joints) {
  const SkinWeights weights(vertices);
  std::vector<foredraw_cage_skin> skin(vertices.count, foredraw_cage_skin{{joints, 0, 0, 0}, {1, 0, 0, 0}});
  std::vector<SkinWeights::Slot> row;
  for (std::uint32_t v = 0; v < vertices.count; ++v) {
    row.clear();
    for (const SkinWeights::Slot& slot : weights.of(v)) {
      if (slot.joint < joints && slot.weight > 0) row.push_back(slot);
    }
    std::ranges::sort(row, [](const SkinWeights::Slot& a, const SkinWeights::Slot& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
    });
    if (row.size() > 4) row.resize(4);
    float sum = 0;
    for (const SkinWeights::Slot& slot : row) sum += slot.weight;
    for (std::size_t c = 0; c < row.size(); ++c) {
      skin[v].joint[c] = row[c].joint;
      skin[v].weight[c] = row[c].weight / sum;
    }
  }
  return skin;
}

}  // namespace foredraw
