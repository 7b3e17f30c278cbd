#pragma once
// Which sides of a subject a picture needs: those without which it changes.

#include "all_sides.h"
#include "side_rays.h"

#include <foredraw/base/parallel.h>
#include <foredraw/scene/views.h>

#include <cstdint>

namespace foredraw::processors::sides {

/// Of 2^24 in the picture's depth: what moves by no more is no other surface. At outlines the backs of closed bodies
/// win by a few.
inline constexpr std::uint32_t most_steps_apart = 64;

struct Needed {
  std::uint64_t pixels = 0;  ///< that would change
  std::uint64_t shown = 0;   ///< that show anything
  std::vector<Seen> seen;    ///< sides that were added, and backs that are nearest in a pixel; view by view
};

/// Draws every side, and the sides in `kept` alone, from all views; where a pixel's nearest surface is lost, or moves
/// by more than most_steps_apart, the side that is nearest there is added to `kept` ([part][triangle], as many as the
/// subject's parts have). A side that holes cut by a mask leave out of a pixel is not in it.
Needed add_needed_by_pictures(const AllSides& all, SidesOfParts& kept, const Views& views, const Executor& executor);

}  // namespace foredraw::processors::sides
