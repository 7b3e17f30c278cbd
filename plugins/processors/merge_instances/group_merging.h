#pragma once
// Groups made fewer where that costs less.

#include "group_tree.h"

namespace foredraw::processors::merge_instances {

/// Merges neighbouring groups, the pair that saves most first, as long as one saves anything. Answers with the group
/// that each of `groups` belongs to afterwards, numbered from 0 in the sequence of their first members.
std::vector<std::uint32_t> merged_neighbours(std::span<const GroupSum> groups, const SeenBoxes& seen_boxes,
                                             const GroupOptions& options);

}  // namespace foredraw::processors::merge_instances
