#pragma once
// Where a surface passes through itself.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/base/parallel.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace foredraw {

/// [triangle] 1: an edge of it goes through the inside of another one, or the other way round, for certain: what only
/// touches, within the rounding of doubles, and what lies in one plane does not cross. Triangles with a corner at one
/// position are not asked of each other, nor those that are not finite; each is held against 512 others whose boxes
/// meet its own, at most. O(n log n); soon over once `cancel` is set, with what is known by then.
std::vector<std::uint8_t> crossing_triangles(const Surface& surface, const Executor& executor,
                                             const std::atomic<bool>* cancel = nullptr);

}  // namespace foredraw
