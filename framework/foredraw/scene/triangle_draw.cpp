#include <foredraw/scene/triangle_draw.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

Draw triangle_draw(std::string name, std::span<const glm::vec3> positions, std::vector<std::uint32_t> indices,
                   std::vector<VertexStream> streams) {
  if (indices.size() % 3 != 0) throw std::invalid_argument(name + ": the number of indices is not a multiple of three");
  if (std::ranges::any_of(indices, [&](std::uint32_t index) { return index >= positions.size(); })) {
    throw std::invalid_argument(name + ": an index names a position that does not exist");
  }
  for (const VertexStream& stream : streams) {
    if (stream.count() != positions.size()) {
      throw std::invalid_argument(name + ": " + stream.semantic + " is not as long as the positions");
    }
  }
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(positions.size());
  vertices.base = std::move(streams);
  vertices.base.insert(vertices.base.begin(), float_stream("POSITION", positions));

  Level level;
  level.vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  level.orders.push_back({.indices = Shared<std::uint32_t>(std::move(indices))});
  Draw draw;
  draw.name = std::move(name);
  draw.levels.push_back(std::move(level));
  return draw;
}

}  // namespace foredraw
