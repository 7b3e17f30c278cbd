#pragma once
// What one draw call draws: a glTF primitive.

#include <foredraw/scene/clusters.h>
#include <foredraw/scene/material.h>
#include <foredraw/scene/sprite.h>
#include <foredraw/scene/traits.h>
#include <foredraw/scene/vertex_streams.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace foredraw {

using DrawId = std::uint32_t;

/// The address of a level of detail; level 0 is full detail.
struct DrawLevel {
  DrawId draw = 0;
  std::size_t level = 0;
};

/// Three indices a triangle (two a line, one a point). Strips and fans are held as lists.
struct IndexStream {
  Shared<std::uint32_t> indices;
  std::optional<Clusters> clusters;
  std::uint16_t cache_size = 0;           ///< the order was made for a cache of so many entries; 0: unknown
  Shared<std::uint32_t> triangle_origin;  ///< [new] = the triangle's number in the file; empty: as in the file

  std::size_t triangle_count() const { return indices.size() / 3; }
};

/// Where in its file a draw came from.
struct DrawOrigin {
  std::uint32_t mesh = 0;
  std::uint32_t primitive = 0;
  friend bool operator==(const DrawOrigin&, const DrawOrigin&) = default;
};

/// One level of detail. orders[0] stands alone: whoever knows nothing of the others draws it.
struct Level {
  std::shared_ptr<const VertexStreams> vertices;
  std::vector<IndexStream> orders;
  float error = 0;                           ///< largest distance from level 0, either way, in the draw's units
  Shared<std::uint32_t> vertex_destination;  ///< [number in the file] = number now, or no_vertex; empty: as in the file
  Traits made = {};                          ///< by stages; what was found in the asset stands with the draw
  std::optional<DrawOrigin> origin = {};     ///< of a coarser level that is a primitive of its own in the file

  const IndexStream& stream() const { return orders.front(); }
  IndexStream& stream() { return orders.front(); }
};

/// Stands in a vertex destination for a vertex that no triangle uses and that was left out.
inline constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

enum class Topology : std::uint8_t { triangles, lines, points };

/// How the units of a draw read in those that it had in its file: offset + scale * position. A stage that changed them
/// changed with them what places the draw.
struct DrawSpace {
  glm::dvec3 offset{0};
  double scale = 1;
  friend bool operator==(const DrawSpace&, const DrawSpace&) = default;
};

/// A position from the units of one space to those of another one, both of the same draw.
inline glm::vec3 position_in(const DrawSpace& to, const DrawSpace& from, const glm::vec3& position) {
  if (to == from) return position;
  return glm::vec3((from.offset + from.scale * glm::dvec3(position) - to.offset) / to.scale);
}

struct Draw {
  std::string name;           ///< the mesh's, and a number where the mesh has several draws: "Rock", "House/1"
  std::vector<Level> levels;  ///< from full detail to the coarsest; never empty
  Topology topology = Topology::triangles;
  std::optional<MaterialId> material;
  Traits traits;  ///< found in the asset; traits_of() has those of a level that stages made too
  std::optional<DrawOrigin> origin;
  std::optional<SpriteFrame> frame;  ///< of a draw that shows a part of an image
  DrawSpace space = {};

  const Level& full() const { return levels.front(); }
  Level& full() { return levels.front(); }
  /// The coarsest one, where there are fewer.
  const Level& level(std::size_t number) const { return levels[std::min(number, levels.size() - 1)]; }
};

}  // namespace foredraw
