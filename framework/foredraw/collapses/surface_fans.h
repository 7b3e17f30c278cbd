#pragma once
// A mesh as libraries of half-edges can hold it: a manifold, with borders.

#include <foredraw/collapses/collapse_recorder.h>

namespace foredraw {

/// A point is taken apart into its fans: triangles that one meets one after the other across its edges. So a manifold
/// has one for each point. Surfaces come apart along edges of more than two triangles, or of two that face different
/// sides, and at points where only they touch.
struct SurfaceFans {
  std::vector<CollapseRecorder::Corners> corners;  ///< [triangle] fans; no two triangles have an edge in one direction
  std::vector<std::uint32_t> point;                ///< [fan]
  std::vector<bool> is_held;                       ///< [fan] the surface came apart here: to stay where it is
};

/// Of the triangles that a recorder begins with.
SurfaceFans surface_fans(std::span<const CollapseRecorder::Corners> points);

}  // namespace foredraw
