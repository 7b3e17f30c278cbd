#pragma once
// Whole pieces of a mesh that may go at once. A mesh of very many pieces can not become coarser otherwise, since each
// needs some triangles as long as it is there.

#include "collapsing_mesh.h"

#include <foredraw/collapses/collapse_sequence.h>

#include <optional>

namespace foredraw::processors::quadric_collapse {

class WholeParts {
 public:
  /// Pieces of the mesh as it is: what edges connect. Their diagonal is at most `largest` of the mesh's; what is larger
  /// is worth its triangles. `stream[vertex]`: of which vertices one may take another's place; none: of all.
  WholeParts(const CollapsingMesh& mesh, double largest, std::span<const std::uint32_t> stream);

  std::size_t count() const { return pieces_.size(); }
  /// The squared distances of all of it from what will be left, by area, if that is about a quarter of its diagonal
  /// away.
  double cost(std::size_t part) const { return pieces_[part].cost; }
  /// Whether no triangles of other parts are among those that are left.
  bool is_all(std::size_t part, std::size_t faces_left) const;

  struct Step {
    std::uint32_t removed = 0, kept = 0;  ///< points
  };
  /// The next collapse on the way to nothing, and the vertices that take each other's place. Nothing when it is gone.
  std::optional<Step> next(std::size_t part, std::vector<VertexPair>& pairs);

 private:
  struct Piece {
    std::uint32_t first = 0, end = 0;  ///< in by_part_; those before first are gone
    double cost = 0;
  };

  bool can_vanish(const Piece& piece, std::span<const std::uint32_t> stream) const;

  const CollapsingMesh& mesh_;
  std::vector<std::uint32_t> by_part_;  ///< points
  std::vector<Piece> pieces_;
};

}  // namespace foredraw::processors::quadric_collapse
