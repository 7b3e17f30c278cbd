#include "spatial_groups.h"

#include <foredraw/geometry/finite.h>

#include "group_merging.h"
#include "group_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace foredraw::processors::merge_instances {

namespace {

constexpr std::size_t chunk = 16384;  ///< instances that a task looks at: fixed, whatever the number of threads

Box<glm::vec3> scene_box(std::span<const PlacedBox> instances) {
  Box<glm::vec3> all;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Box<glm::vec3>& box = instances[i].box;
    if (!is_finite(box.min) || !is_finite(box.max) || box.is_empty() || !(box.min.y <= box.max.y) ||
        !(box.min.z <= box.max.z)) {
      throw std::invalid_argument("instance " + std::to_string(i) + " has no finite bounding box");
    }
    all.add(box);
  }
  return all;
}

double view_distance_in(const Box<glm::vec3>& scene, const GroupOptions& options) {
  if (options.view_distance > 0) return options.view_distance;
  const glm::dvec3 side = glm::dvec3(scene.max) - glm::dvec3(scene.min);
  const double diagonal = std::sqrt(side.x * side.x + side.y * side.y + side.z * side.z);
  return diagonal > 0 ? diagonal / 4 : 1;
}

std::vector<TreeItem> items_of(std::span<const PlacedBox> instances, const SeenBoxes& seen_boxes,
                               const Executor& executor) {
  std::vector<TreeItem> items(instances.size());
  executor.for_each((instances.size() + chunk - 1) / chunk, [&](std::size_t task) {
    const std::size_t end = std::min(instances.size(), (task + 1) * chunk);
    for (std::size_t i = task * chunk; i < end; ++i) {
      const PlacedBox& placed = instances[i];
      items[i] = {placed.box, placed.indices, static_cast<std::uint32_t>(i), seen_boxes(placed.box) * placed.indices};
    }
  });
  return items;
}

GroupCost cost_of(std::span<const GroupSum> groups, const SeenBoxes& seen_boxes) {
  GroupCost cost;
  for (const GroupSum& group : groups) {
    ++cost.draws;
    cost.wasted += group.wasted(seen_boxes);
  }
  return cost;
}

}  // namespace

SpatialGroups spatial_groups(std::span<const PlacedBox> instances, const GroupOptions& options,
                             const Executor& executor) {
  SpatialGroups result;
  if (instances.empty()) return result;
  const Box<glm::vec3> scene = scene_box(instances);
  result.view_distance = view_distance_in(scene, options);
  const SeenBoxes seen_boxes(scene, result.view_distance);
  std::vector<TreeItem> items = items_of(instances, seen_boxes, executor);
  const std::vector<TreeGroup> tree = tree_groups(items, seen_boxes, options, executor);

  std::vector<GroupSum> groups;
  for (const TreeGroup& group : tree) groups.push_back(group.sum);
  result.before_merging = cost_of(groups, seen_boxes);
  std::vector<std::uint32_t> group_of(groups.size());
  if (options.merge_neighbours) {
    group_of = merged_neighbours(groups, seen_boxes, options);
  } else {
    for (std::uint32_t g = 0; g < group_of.size(); ++g) group_of[g] = g;
  }

  const std::size_t count = static_cast<std::size_t>(*std::ranges::max_element(group_of)) + 1;
  std::vector<GroupSum> merged(count);
  for (std::size_t g = 0; g < groups.size(); ++g) merged[group_of[g]].add(groups[g]);
  result.cost = cost_of(merged, seen_boxes);
  result.first.assign(count + 1, 0);
  for (std::size_t g = 0; g < count; ++g) {
    result.bounds.push_back(merged[g].box);
    result.first[g + 1] = result.first[g] + static_cast<std::uint32_t>(merged[g].instances);
  }
  std::vector<std::uint32_t> of_instance(instances.size());
  for (std::size_t g = 0; g < tree.size(); ++g) {
    for (std::size_t i = tree[g].begin; i < tree[g].end; ++i) of_instance[items[i].instance] = group_of[g];
  }
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  result.instances.resize(instances.size());
  for (std::uint32_t i = 0; i < instances.size(); ++i) result.instances[next[of_instance[i]]++] = i;
  return result;
}

GroupCost best_grid(std::span<const PlacedBox> instances, const GroupOptions& options) {
  if (instances.empty()) return {};
  const Box<glm::vec3> scene = scene_box(instances);
  const SeenBoxes seen_boxes(scene, view_distance_in(scene, options));
  const glm::dvec3 side = glm::dvec3(scene.max) - glm::dvec3(scene.min);
  const double longest = std::max({side.x, side.y, side.z});
  GroupCost best{0, std::numeric_limits<double>::infinity()};
  for (std::uint64_t along = 1; along <= 1024; along *= 2) {
    const auto cell_of = [&](const Box<glm::vec3>& box) {
      std::uint64_t key = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double middle = (double{box.min[axis]} + double{box.max[axis]}) / 2 - double{scene.min[axis]};
        const double at = longest > 0 ? middle / longest * static_cast<double>(along) : 0;
        key = key * along + std::min(along - 1, static_cast<std::uint64_t>(at));
      }
      return key;
    };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> cells;
    for (std::uint32_t i = 0; i < instances.size(); ++i) cells.push_back({cell_of(instances[i].box), i});
    std::ranges::sort(cells);
    GroupCost cost;
    for (std::size_t begin = 0; begin < cells.size();) {
      GroupSum sum;
      std::size_t end = begin;
      for (; end < cells.size() && cells[end].first == cells[begin].first; ++end) {
        const PlacedBox& placed = instances[cells[end].second];
        sum.add({placed.box, placed.indices, 1, seen_boxes(placed.box) * placed.indices});
      }
      cost.draws += std::max((sum.indices + options.most_indices - 1) / options.most_indices,
                             (sum.instances + options.most_instances - 1) / options.most_instances);
      cost.wasted += sum.wasted(seen_boxes);
      begin = end;
    }
    if (cost.total(options.draw_cost) < best.total(options.draw_cost)) best = cost;
  }
  return best;
}

}  // namespace foredraw::processors::merge_instances
