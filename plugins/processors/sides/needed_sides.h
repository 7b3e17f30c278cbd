#pragma once
// Which sides of a subject a picture needs: those without which it changes.

#include "all_sides.h"

#include <foredraw/analysis/ray_tree.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/views.h>

#include <cstdint>

namespace foredraw::sides {

/// Of 2^24 in the picture's depth: what moves by no more is no other surface. At outlines the backs of closed bodies
/// win by a few.
inline constexpr std::uint32_t most_steps_apart = 64;

struct Needed {
  std::uint64_t pixels = 0;  ///< that would change
  std::uint64_t shown = 0;   ///< that show anything
};

/// Draws every side, and the sides in `kept` alone, from all views; where a pixel's nearest surface is lost, or moves
/// by more than most_steps_apart, the side that is nearest there is added to `kept` ([part][triangle], as many as the
/// subject's parts have). A side that holes cut by a mask leave out of a pixel is not in it.
Needed add_needed_by_pictures(const AllSides& all, SidesOfParts& kept, const Views& views, const Executor& executor);

struct RayOptions {
  std::size_t rays = 256;  ///< of a side
  std::uint64_t seed = 0;
};

/// Asks the tree of the parts for the sides `wanted` ([part][triangle]) by rays from points all over them: what leaves
/// the subject unblocked is seen by a camera out there, and the side is added to `kept`. Returns how many sides were
/// added.
std::size_t add_needed_by_rays(const RayTree& tree, std::span<const RasterPart> parts, const SidesOfParts& wanted,
                               SidesOfParts& kept, const RayOptions& options, const Executor& executor);

/// What blocks rays, numbered through the parts. Masked parts block nothing.
RayTree tree_of(std::span<const RasterPart> parts);

}  // namespace foredraw::sides
