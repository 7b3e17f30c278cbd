#pragma once
// Placed instances that lie together, as groups that are culled and drawn as one.

#include "seen_boxes.h"

#include <foredraw/base/parallel.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::merge_instances {

struct PlacedBox {
  Box<glm::vec3> box;  ///< in the world; finite, not empty
  std::uint32_t indices = 0;
};

struct GroupOptions {
  /// What a draw costs, in index entries that are drawn though nobody sees them: about what a GPU draws in the time of
  /// a small draw call.
  double draw_cost = 4096;
  std::uint64_t most_indices = 1u << 24;    ///< of a group; one instance alone may have more
  std::uint32_t most_instances = 1u << 16;  ///< of a group
  double most_size = 0;                     ///< of a group's box, its longest side; one instance may have more; 0: any
  double view_distance = 0;                 ///< of cameras, in the scene's units; 0: a quarter of its diagonal
  bool merge_neighbours = true;             ///< improve what the tree found
};

/// What groups cost a frame, expected over all cameras: draws, and entries that are drawn because the group's bound is
/// seen where the instance's own is not.
struct GroupCost {
  std::uint64_t draws = 0;
  double wasted = 0;  ///< index entries
  double total(double draw_cost) const { return static_cast<double>(draws) * draw_cost + wasted; }
};

struct SpatialGroups {
  std::vector<std::uint32_t> instances;  ///< numbers of the instances, group after group, rising in each
  std::vector<std::uint32_t> first{0};   ///< [group] where it begins in `instances`; and the end
  std::vector<Box<glm::vec3>> bounds;    ///< [group]
  GroupCost cost;
  GroupCost before_merging;  ///< of the tree's groups
  double view_distance = 0;  ///< that was reckoned with

  std::size_t size() const { return bounds.size(); }
  std::span<const std::uint32_t> of(std::size_t group) const {
    return std::span(instances).subspan(first[group], first[group + 1] - first[group]);
  }
};

/// Groups of low cost. A tree is built downwards by the best of 16 cuts along each axis, and only as far as a cut can
/// pay: groups that waste less than a draw costs are whole. Of all sets of its nodes that hold each instance once, the
/// cheapest is taken, exactly; then neighbours from different branches are merged, the best pair first, as long as the
/// cost falls. O(n log n). The same at any number of threads. Throws std::invalid_argument where a box is empty or not
/// finite.
SpatialGroups spatial_groups(std::span<const PlacedBox> instances, const GroupOptions& options,
                             const Executor& executor);

/// For comparison: the cost of the cheapest grid of equal cubes, from one cell along the longest side to 1024 in powers
/// of two. Each instance is in its middle's cell, and cells beyond the budgets take as many draws as these allow.
GroupCost best_grid(std::span<const PlacedBox> instances, const GroupOptions& options);

}  // namespace foredraw::processors::merge_instances
