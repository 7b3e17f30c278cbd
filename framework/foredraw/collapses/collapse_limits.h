#pragma once
// How far a sequence of collapses may run.

#include <foredraw/collapses/draw_distances.h>

namespace foredraw {

/// The distance that covers so many pixels of a picture, 1080 pixels high with a field of view of 60 degrees, as seen
/// from so many units away.
double distance_of_pixels(double pixels, double away);

/// The fewest collapses after which no more than that many triangles are left; all, where there are always more. `run`
/// is that of the sequence.
std::size_t collapses_to(const Replay& run, std::uint32_t triangles);

/// The most collapses that leave each draw a triangle that had one at first. A draw of none is nothing to measure from.
std::size_t collapses_that_leave_draws(const CollapseSequence& sequence, const JoinedMesh& mesh);

/// The most collapses, of `least` to `most`, for which each draw is proved to lie within the distance; `least`, where
/// none does. The distance hardly ever falls as edges collapse: the answer is found by halving.
std::size_t collapses_within(const CollapseSequence& sequence, const JoinedMesh& mesh, const DrawDistances& distances,
                             double distance, std::size_t least, std::size_t most, const FarthestOptions& search,
                             const Executor& executor);

}  // namespace foredraw
