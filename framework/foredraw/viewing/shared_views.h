#pragma once
// Views shared out among poses, so that many poses cost little more than one.

#include <foredraw/scene/views.h>

#include <cstddef>
#include <span>
#include <vector>

namespace foredraw {

/// [pose] numbers of views, rising: so many looks in all (at most every view in every pose), of which every pose and
/// every view gets as many as another or one less; and those of a pose lie far from each other. The same on every
/// machine. O(looks * views).
std::vector<std::vector<std::size_t>> shared_views(std::span<const View> views, std::size_t poses, std::size_t looks);

}  // namespace foredraw
