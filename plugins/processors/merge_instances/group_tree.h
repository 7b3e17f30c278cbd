#pragma once
// The cheapest groups that a tree of boxes holds.

#include "spatial_groups.h"

#include <algorithm>

namespace foredraw::processors::merge_instances {

/// What is known of some instances together. Sums are taken in a fixed sequence, so they are the same everywhere.
struct GroupSum {
  Box<glm::vec3> box;
  std::uint64_t indices = 0;
  std::uint64_t instances = 0;
  double seen = 0;  ///< entries that are drawn where each instance is culled alone

  void add(const GroupSum& other) {
    box.add(other.box);
    indices += other.indices;
    instances += other.instances;
    seen += other.seen;
  }
  double wasted(const SeenBoxes& seen_boxes) const {
    const double waste = seen_boxes(box) * static_cast<double>(indices) - seen;
    return waste > 0 ? waste : 0;  // a rounding below it where there is none
  }
  bool is_within(const GroupOptions& options) const {
    const glm::vec3 side = box.max - box.min;
    const bool is_small = options.most_size <= 0 || std::max({side.x, side.y, side.z}) <= options.most_size;
    return instances <= 1 || (is_small && indices <= options.most_indices && instances <= options.most_instances);
  }
};

/// An instance as the tree moves it about.
struct TreeItem {
  Box<glm::vec3> box;
  std::uint32_t indices = 0;
  std::uint32_t instance = 0;
  double seen = 0;

  GroupSum sum() const { return {box, indices, 1, seen}; }
};

struct TreeGroup {
  std::size_t begin = 0, end = 0;  ///< among the items
  GroupSum sum;
};

/// Puts the items into groups one behind the other.
std::vector<TreeGroup> tree_groups(std::span<TreeItem> items, const SeenBoxes& seen_boxes, const GroupOptions& options,
                                   const Executor& executor);

}  // namespace foredraw::processors::merge_instances
