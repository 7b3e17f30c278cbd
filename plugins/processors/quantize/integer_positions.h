#pragma once
// Positions as whole numbers of 16 bits (KHR_mesh_quantization): p = step * (first + number). What places a draw takes
// the step in (scale_back.h), so all draws that a node or a skin places together have the same grid.

#include "lattices.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

/// Where the whole numbers lie in the space that a draw had.
struct PositionGrid {
  double step = 1;                      ///< a float, and so is every whole multiple that is used
  std::array<std::int64_t, 3> first{};  ///< multiples of the step: the number 0 lies there

  glm::vec3 offset() const;
};

struct IntegerPositions {
  std::vector<std::optional<PositionGrid>> grids;  ///< [draw] none: its positions stay floats
  /// [draw] what floats may be off, where some draw of their lattice has a grid: less than before, so that both have
  /// the same points.
  std::vector<double> tolerances;
  std::vector<std::pair<DrawId, std::string>> staying;  ///< the first draw of what stays floats together, and why
};

/// Finds a grid for whatever can have one. `groups`: those whose vertices may change.
IntegerPositions integer_positions(const Scene& scene, const std::vector<DrawId>& draws,
                                   const std::vector<VertexGroup>& groups, Lattices& lattices, Analyses& analyses);

struct OnGrid {
  std::shared_ptr<const VertexStreams> vertices;
  double error = 0;  ///< the largest distance of a position, also of a morph target, in units of before
};

/// Positions as numbers of 16 bits without a sign, those of morph targets as such with one and without `first`. All
/// positions have a number.
OnGrid on_grid(const VertexStreams& vertices, const PositionGrid& grid);

}  // namespace foredraw
