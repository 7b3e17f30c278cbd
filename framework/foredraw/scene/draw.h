#pragma once
// What one draw call draws: a glTF primitive.

#include <foredraw/scene/clusters.h>
#include <foredraw/scene/material.h>
#include <foredraw/scene/sprite.h>
#include <foredraw/scene/traits.h>
#include <foredraw/scene/vertex_streams.h>

#include <memory>
#include <optional>

namespace foredraw {

using DrawId = std::uint32_t;

/// Three indices a triangle (two a line, one a point). Strips and fans are held as lists.
struct IndexStream {
  Shared<std::uint32_t> indices;
  std::optional<Clusters> clusters;
  std::uint16_t cache_size = 0;        ///< the order was made for a cache of so many entries; 0: unknown
  Shared<std::uint32_t> triangle_origin;  ///< [new] = the triangle's number in the file; empty: as in the file

  std::size_t triangle_count() const { return indices.size() / 3; }
};

/// One level of detail. orders[0] stands alone: whoever knows nothing of the others draws it.
struct Level {
  std::shared_ptr<const VertexStreams> vertices;
  std::vector<IndexStream> orders;
  float error = 0;                            ///< geometric deviation from level 0, in the draw's units
  Shared<std::uint32_t> vertex_destination;   ///< [number in the file] = number now, or no_vertex; empty: as in the file
};

/// Stands in a vertex destination for a vertex that no triangle uses and that was left out.
inline constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

enum class Topology : std::uint8_t { triangles, lines, points };

/// Where in its file a draw came from.
struct DrawOrigin {
  std::uint32_t mesh = 0;
  std::uint32_t primitive = 0;
  friend bool operator==(const DrawOrigin&, const DrawOrigin&) = default;
};

struct Draw {
  std::string name;           ///< the mesh's, and a number where the mesh has several draws: "Rock", "House/1"
  std::vector<Level> levels;  ///< levels[0]: full detail; never empty
  Topology topology = Topology::triangles;
  std::optional<MaterialId> material;
  Traits traits;
  std::optional<DrawOrigin> origin;
  std::optional<SpriteFrame> frame;   ///< of a draw that shows a part of an image
};

}  // namespace foredraw
