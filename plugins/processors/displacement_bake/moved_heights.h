#pragma once
#include <foredraw/displaced/baked_heights.h>

#include <optional>

namespace foredraw::processors::displacement_bake {

/// The heights of a draw whose triangles came into another order, or whose vertices got other numbers, by where each
/// lies: at a vertex, on an edge between two, or inside of a triangle. Nothing where the triangles are others.
std::optional<DrawHeights> moved(const DrawHeights& heights, const Level& before, const Level& after);

}  // namespace foredraw::processors::displacement_bake
