#pragma once
// Boxes of the parts of a triangle. The one box of a long, thin triangle that lies across the axes is nearly empty, and
// where many such triangles are beside each other, as around a hub, each point lies in most of their boxes.
// After Ernst and Greiner, "Early Split Clipping for Bounding Volume Hierarchies", IEEE Symposium on Interactive Ray
// Tracing, 2007.

#include <foredraw/analysis/box_tree.h>

#include <array>
#include <cstddef>
#include <vector>

namespace foredraw {

/// How many boxes of equal length are worth their memory: 1 for a triangle whose box is not much larger than it is.
std::size_t boxes_worth_having(const std::array<glm::vec3, 3>& corners);

/// Adds that many boxes, which together hold every point of the triangle. It must be finite. One is its box, exactly.
void add_part_boxes(const std::array<glm::vec3, 3>& corners, std::size_t parts, std::vector<BoxTree::Box>& boxes);

}  // namespace foredraw
