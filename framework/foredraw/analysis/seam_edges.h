#pragma once
// Where a texture's layout is cut: edges whose triangles meet in space, and lie apart in the image.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// A draw with a layout. Both spans have one element a vertex; indices are three a triangle, each below their number.
struct UvMesh {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec2> uvs;  ///< (0, 0) is the upper left corner of the image
  std::span<const std::uint32_t> indices;
};

/// A triangle's edge, as its neighbours see it: from the edge's first point to its second.
struct EdgeSide {
  std::uint32_t mesh = 0;      ///< which of the meshes
  std::uint32_t triangle = 0;  ///< of the mesh
  std::uint8_t corner = 0;     ///< 0 to 2: the edge leads from this corner to the next
  bool is_reversed = false;    ///< the triangle runs along it from the second point to the first
  std::array<glm::vec2, 2> uv{};
};

enum class EdgeKind : std::uint8_t {
  seam,   ///< of two or more sides, not all with the same uvs
  border  ///< of one side
};

struct SharedEdge {
  std::array<std::uint32_t, 2> points{};  ///< the smaller number first
  EdgeKind kind = EdgeKind::seam;
  std::uint32_t first_side = 0;
  std::uint32_t side_count = 0;
};

/// A point that has several uvs, whether along a seam or where parts only touch.
struct UvCorner {
  std::uint32_t point = 0;
  std::uint32_t first_uv = 0;
  std::uint32_t uv_count = 0;  ///< at least 2
};

struct SeamEdges {
  std::vector<SharedEdge> edges;  ///< seams and borders, by their points
  std::vector<EdgeSide> sides;    ///< those of an edge together, by mesh, triangle and corner
  std::vector<UvCorner> corners;  ///< by their points
  std::vector<glm::vec2> uvs;     ///< of corners, each once, in the sequence of meshes and triangles
  std::size_t seams = 0;          ///< how many of the edges
  std::size_t of_many_faces = 0;  ///< edges of three and more sides, seams or not
  std::size_t left_out = 0;       ///< triangles, see below

  std::span<const EdgeSide> sides_of(const SharedEdge& edge) const {
    return std::span(sides).subspan(edge.first_side, edge.side_count);
  }
  std::span<const glm::vec2> uvs_of(const UvCorner& corner) const {
    return std::span(uvs).subspan(corner.first_uv, corner.uv_count);
  }
};

/// Seams, borders and corners of meshes that lie in one space and in one image. A point is a position, bit by bit
/// (welded()), whatever mesh has it; it bears the number of its first vertex, counted over the meshes. A seam is an
/// edge whose sides' uvs differ on that edge: an edge between two vertices with several uvs need not be one. Left out
/// are triangles with two corners at one point, and with a position or uv that is not finite. O(n log n). Once `cancel`
/// is set, what comes out is of no use, and comes soon.
SeamEdges seam_edges(std::span<const UvMesh> meshes, const std::atomic<bool>* cancel = nullptr);

}  // namespace foredraw
