#pragma once
// Draws whose vertices are rounded to the same points, and how far that may move them.

#include "touching_draws.h"

#include <foredraw/geometry/joined_sets.h>
#include <foredraw/scene/subject.h>
#include <foredraw/scene/vertex_groups.h>

#include <vector>

namespace foredraw {

/// The greatest step such that no point of a space of so many dimensions is farther than `distance` (above 0) from the
/// nearest whole multiple, but for its lower bits: it has step_bits. So floats add whole multiples of it without an
/// error, and equal ones of two draws stay equal.
double grid_step(double distance, int dimensions);
inline constexpr int step_bits = 6;

struct Lattices {
  JoinedSets sets;                 ///< of draws
  std::vector<double> tolerances;  ///< [draw] how far a position may be off, alike within a set; 0: positions stay
};

/// How far positions may be off, by the size of a subject's largest draw.
struct PositionTolerance {
  double part = 0;
  bool of_side = false;  ///< of the largest side of its box, else of its diagonal
};

/// Joins the draws that a node or a skin places together: the draws of a mesh, and those of a skin.
void join_placed_together(const Scene& scene, JoinedSets& sets);

/// Draws of one subject have the same lattice, and so have those that share vertices, that meet, and that are placed
/// together: the finest of what each of them asks for.
Lattices lattices_of(const Scene& scene, const std::vector<DrawId>& draws, const std::vector<VertexGroup>& groups,
                     const std::vector<Meeting>& meetings, SubjectUnit unit, const PositionTolerance& tolerance,
                     Analyses& analyses);

}  // namespace foredraw
