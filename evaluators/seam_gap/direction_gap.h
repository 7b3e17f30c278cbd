#pragma once
// How far a surface tears whose vertices move along their normals: where several vertices lie at one position, and
// their normals differ.

#include <foredraw/displaced/smooth_directions.h>

#include <cstddef>
#include <span>

namespace foredraw {

struct DirectionGap {
  std::size_t shared = 0;  ///< positions of several vertices with a normal each, of all parts
  std::size_t split = 0;   ///< of them, with normals that differ by more than a float's rounding
  double largest = 0;      ///< degrees, of these: between a vertex's normal and its position's direction
};

/// Of parts of one space; those without normals are asked for nothing. Directions are those of smooth_directions(),
/// along which nothing tears. Normals that point nowhere, or are no numbers, are left out. O(n log n).
DirectionGap direction_gap(std::span<const DirectedPart> parts);

}  // namespace foredraw
