#include <foredraw/page/private/shown_wires.h>

#include <foredraw/wires/wires.h>

#include <algorithm>
#include <array>
#include <map>

namespace foredraw {

namespace {

bool is_moved(const Scene& scene, const ShownPart& part) {
  if (!scene.draws[part.part.draw].full().vertices->morph_targets.empty()) return true;
  return part.part.node && scene.nodes[*part.part.node].skin;
}

}  // namespace

std::optional<ShownWires> shown_wires(const Scene& scene, const ShownPart& part) {
  const auto* product = scene.products.find<Wires>();
  if (product == nullptr || is_moved(scene, part)) return std::nullopt;
  const DrawWires* of = product->of(part.part.draw);
  if (of == nullptr) return std::nullopt;
  const Level& level = scene.draws[part.part.draw].full();
  const VertexStream* position = level.vertices->find("POSITION");
  const auto of_vertices = decoded_wires(*level.vertices, of->texcoords);
  const std::vector<std::uint32_t>& drawn = part.orders.front().drawn;
  if (position == nullptr || !of_vertices) return std::nullopt;
  if (drawn.size() != level.stream().triangle_count()) return std::nullopt;  // few, of vertices that were moved
  ShownWires wires{.first = of->first_triangle};
  std::map<std::uint32_t, std::uint32_t> row_of;  // [vertex]
  const auto indices = level.stream().indices.view();
  for (std::size_t i = 3 * std::size_t{of->first_triangle}; i < indices.size(); ++i) {
    const std::uint32_t vertex = indices[i];
    const auto [row, is_new] = row_of.try_emplace(vertex, static_cast<std::uint32_t>(row_of.size()));
    wires.corners.push_back(row->second);
    if (!is_new) continue;
    for (std::size_t c = 0; c < 3; ++c) wires.rows.push_back(decode_component(*position, vertex, c));
    for (const auto* values : {&of_vertices->wires, &of_vertices->axes}) {
      for (int c = 0; c < 4; ++c) wires.rows.push_back((*values)[vertex][c]);
    }
  }
  return wires;
}

glm::mat4 shown_from_mesh(const ShownPart& part, const PosedNodes& nodes) {
  return part.part.node ? nodes.world[*part.part.node] : glm::mat4(1);
}

}  // namespace foredraw
