#pragma once
// What a simplifier does to a mesh, kept as a sequence of collapses. For those whose own data know neither seams nor
// surfaces that are no manifolds: they propose, it says what may be, and remembers.

#include <foredraw/collapses/collapse_sequence.h>

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <span>

namespace foredraw {

/// What becomes of the point that is kept.
struct JoinedPoint {
  float blend = 0;                 ///< as in Collapse
  double error = 0;                ///< as in Collapse; where it is less than one before, that one stands
  std::optional<glm::vec3> place;  ///< where it lies; of all collapses of a sequence, or of none
};

/// Of a place beside an edge: how far it lies from the kept point towards the removed one, 0 to 1.
float blend_of(glm::vec3 kept, glm::vec3 removed, glm::vec3 place);

class CollapseRecorder {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// `indices` holds three a triangle, each below the number of positions; any triangles will do. Those with two
  /// corners at one point are not there. Points are known by their first vertex.
  CollapseRecorder(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

  std::size_t triangle_count() const { return left_; }  ///< that are left
  /// Of each triangle that is left or was: the points at its corners, and the vertices.
  std::span<const Corners> points() const { return points_; }
  std::span<const Corners> vertices() const { return vertices_; }
  /// Those that are left, at a point.
  std::span<const std::uint32_t> triangles_at(std::uint32_t point) const { return triangles_at_[point]; }
  /// How often a triangle at the point has changed.
  std::uint32_t changes(std::uint32_t point) const { return changes_[point]; }
  bool is_finite(std::uint32_t point) const { return is_finite_[point]; }
  /// How many triangles have both points.
  std::size_t triangles_of_edge(std::uint32_t p, std::uint32_t q) const;

  /// Whether the surface keeps its topology when the edge is gone, and something is left of it. False where a position
  /// is not finite.
  bool keeps_topology(std::uint32_t p, std::uint32_t q);
  /// Whether the triangles between both say one to one which vertex of `kept` each vertex of `removed` becomes. If not,
  /// a seam would open, close or jump.
  bool pairs_up(std::uint32_t removed, std::uint32_t kept);
  /// Of the last answer of pairs_up() that was true.
  std::span<const VertexPair> pairs() const { return pairs_; }

  /// Two points that pair up.
  void collapse(std::uint32_t removed, std::uint32_t kept, const JoinedPoint& joined);
  /// All collapses so far.
  CollapseSequence take();

 private:
  static bool has(const Corners& corners, std::uint32_t point);
  static int corner_of(const Corners& points, std::uint32_t point);
  void find_shared(std::uint32_t p, std::uint32_t q);
  bool is_border(std::uint32_t p);

  std::vector<Corners> points_, vertices_;                // [triangle]
  std::vector<std::vector<std::uint32_t>> triangles_at_;  // [point]
  std::vector<std::uint32_t> changes_;                    // [point]
  std::vector<std::uint64_t> marks_;                      // [point]
  std::vector<bool> is_finite_;                           // [point]
  std::vector<std::uint32_t> shared_;
  std::vector<VertexPair> pairs_;
  std::uint64_t mark_ = 0;
  std::size_t left_ = 0;
  CollapseSequence sequence_;
};

}  // namespace foredraw
