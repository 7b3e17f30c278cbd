#include <foredraw/report/page/private/shown_wires.h>

#include <foredraw/scene/wires.h>

#include <algorithm>
#include <array>
#include <map>

namespace foredraw {

namespace {

/// Null where the draw has no such stream of four floats.
const VertexStream* stream_of(const VertexStreams& vertices, std::string_view semantic) {
  const VertexStream* stream = vertices.find(semantic);
  const bool fits = stream != nullptr && stream->format.component == Component::float32 &&
                    stream->format.components == 4 && stream->count() == vertices.count;
  return fits ? stream : nullptr;
}

bool is_moved(const Scene& scene, const ShownPart& part) {
  if (!scene.draws[part.part.draw].full().vertices->morph_targets.empty()) return true;
  return part.part.node && scene.nodes[*part.part.node].skin;
}

}  // namespace

std::optional<ShownWires> shown_wires(const Scene& scene, const ShownPart& part) {
  const auto* product = scene.products.find<Wires>();
  if (product == nullptr || is_moved(scene, part)) return std::nullopt;
  const auto of = std::ranges::find(product->draws, part.part.draw, &DrawWires::draw);
  if (of == product->draws.end()) return std::nullopt;
  const Level& level = scene.draws[part.part.draw].full();
  const VertexStreams& vertices = *level.vertices;
  const VertexStream *position = vertices.find("POSITION"), *wire = stream_of(vertices, wire_semantic),
                     *axis = stream_of(vertices, wire_axis_semantic);
  const std::vector<std::uint32_t>& drawn = part.orders.front().drawn;
  if (position == nullptr || wire == nullptr || axis == nullptr) return std::nullopt;
  if (drawn.size() != level.stream().triangle_count()) return std::nullopt;  // few, of vertices that were moved
  ShownWires wires{.first = of->first_triangle};
  std::map<std::uint32_t, std::uint32_t> row_of;  // [vertex]
  const auto indices = level.stream().indices.view();
  for (std::size_t i = 3 * std::size_t{of->first_triangle}; i < indices.size(); ++i) {
    const std::uint32_t vertex = indices[i];
    const auto [row, is_new] = row_of.try_emplace(vertex, static_cast<std::uint32_t>(row_of.size()));
    wires.corners.push_back(row->second);
    if (!is_new) continue;
    for (const auto& [stream, count] : {std::pair{position, 3u}, {wire, 4u}, {axis, 4u}}) {
      for (std::size_t c = 0; c < count; ++c) wires.rows.push_back(decode_component(*stream, vertex, c));
    }
  }
  return wires;
}

glm::mat4 shown_from_mesh(const ShownPart& part, const PosedNodes& nodes) {
  return part.part.node ? nodes.world[*part.part.node] : glm::mat4(1);
}

}  // namespace foredraw
