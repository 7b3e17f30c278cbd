#pragma once
// Where a skinned surface tears in poses: several vertices lie at one position, and follow joints in different ways.

#include <foredraw/scene/vertex_streams.h>

#include <cstddef>
#include <span>

namespace foredraw {

struct InfluenceGap {
  std::size_t shared = 0;   ///< positions of several vertices that follow joints
  std::size_t unequal = 0;  ///< of them, those of whose vertices two give a joint another weight
};

/// Of parts of one space; those without joints are asked for nothing. All sets JOINTS_n and WEIGHTS_n count, over the
/// sum of their weights, in any sequence; equal are weights that differ by no more than a float's rounding, 1e-6.
/// O(n log n).
InfluenceGap influence_gap(std::span<const VertexStreams* const> parts);

}  // namespace foredraw
