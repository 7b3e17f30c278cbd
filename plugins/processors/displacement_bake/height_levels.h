#pragma once
// Which triangles of a cage need how many heights.

#include "cast_heights.h"

#include <cstdint>

namespace foredraw::processors::displacement_bake {

/// Heights at one level everywhere.
struct UniformHeights {
  TessellatedMesh mesh;
  std::vector<float> heights;  ///< [vertex of the mesh]
};

/// [log2 of the level] up to that of `finest`, a power of two up to 64.
std::vector<UniformHeights> uniform_heights(const Cage& cage, const Target& target, std::uint32_t finest,
                                            const Executor& executor);

/// [triangle] log2 of the level: the fewest heights whose predicted deviation from those of the finest level, root of
/// the mean square by area, is at most `rms`. Of each triangle's levels only those count that save most for what they
/// cost (the lower hull), and steps are taken by that, so the answer is within one step of the best.
std::vector<std::uint8_t> levels_for(const Cage& cage, std::span<const UniformHeights> heights, double rms);

}  // namespace foredraw::processors::displacement_bake
