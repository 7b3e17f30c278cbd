#pragma once
#include <foredraw/base/content_hash.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace foredraw {

/// The triangles of a draw that a page shows: all of them, or of a large draw so many that a browser can turn them.
struct ShownTriangles {
  std::vector<std::uint32_t> triangles;  ///< their numbers in the draw, rising
  std::vector<std::uint32_t> indices;    ///< three a triangle, into `vertices`
  std::vector<std::uint32_t> vertices;   ///< their numbers in the draw, rising
};

/// Vertices that fall into the same cell of a grid become one of them (Rossignac and Borrel 1993), on the finest grid
/// that leaves at most so many triangles; those that it flattens are left out. All triangles where they are few enough.
/// Triangles with a corner that is not finite are never shown. Each triangle that is left is one of the draw's, so that
/// every order of the draw is an order of these.
ShownTriangles shown_triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               std::size_t at_most);

/// The same, searched for once in all scenes that draw the same: the search looks at every vertex some twenty times.
class ShownTrianglesOnce {
 public:
  ShownTriangles of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, std::size_t at_most);

 private:
  std::map<Stamp, ShownTriangles> found_;  ///< those that are not all
};

}  // namespace foredraw
