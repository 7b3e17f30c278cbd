#include "group_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace foredraw::processors::merge_instances {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t bins = 16;
constexpr int cut_by_halves = 48;           ///< levels below which cuts are by number: bounds the depth
constexpr std::size_t subtree_size = 4096;  ///< instances, below which a subtree is one task

/// The cheapest groups of a subtree.
struct Cut {
  double cost = 0;
  std::vector<TreeGroup> groups;
};

class Builder {
 public:
  Builder(std::span<TreeItem> items, const SeenBoxes& seen_boxes, const GroupOptions& options)
      : items_(items), seen_boxes_(seen_boxes), options_(options) {}

  struct Node {
    std::size_t begin = 0, end = 0;
    int depth = 0;
    GroupSum sum;
    std::optional<std::array<std::size_t, 2>> children;
    std::optional<std::size_t> task;
  };

  /// The top of the tree, down to subtrees that are tasks.
  void plant() {
    nodes_.push_back(node_of(0, items_.size(), 0));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (is_whole(nodes_[i])) continue;
      if (nodes_[i].end - nodes_[i].begin <= subtree_size) {
        nodes_[i].task = tasks_.size();
        tasks_.push_back(i);
        continue;
      }
      const std::array<Node, 2> halves = cut(nodes_[i]);
      nodes_[i].children = {nodes_.size(), nodes_.size() + 1};
      nodes_.insert(nodes_.end(), halves.begin(), halves.end());
    }
    cuts_.resize(tasks_.size());
  }

  std::size_t task_count() const { return tasks_.size(); }
  void run(std::size_t task) { cuts_[task] = grow(nodes_[tasks_[task]]); }

  std::vector<TreeGroup> harvest() {
    std::vector<Cut> best(nodes_.size());
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      if (nodes_[i].task) {
        best[i] = std::move(cuts_[*nodes_[i].task]);
      } else if (nodes_[i].children) {
        const auto [left, right] = *nodes_[i].children;
        best[i] = better(nodes_[i], std::move(best[left]), std::move(best[right]));
      } else {
        best[i] = whole(nodes_[i]);
      }
    }
    return std::move(best[0].groups);
  }

 private:
  Node node_of(std::size_t begin, std::size_t end, int depth) const {
    Node node{begin, end, depth, {}, {}, {}};
    for (const TreeItem& item : items_.subspan(begin, end - begin)) node.sum.add(item.sum());
    return node;
  }

  std::array<Node, 2> cut_by_number(const Node& node) const {
    const std::size_t middle = node.begin + (node.end - node.begin) / 2;
    return {node_of(node.begin, middle, node.depth + 1), node_of(middle, node.end, node.depth + 1)};
  }

  double cost_of(const Node& node) const {
    return node.sum.is_within(options_) ? options_.draw_cost + node.sum.wasted(seen_boxes_) : infinity;
  }

  /// Two groups are two draws, whatever they waste.
  bool is_whole(const Node& node) const {
    return node.end - node.begin <= 1 || cost_of(node) <= 2 * options_.draw_cost;
  }

  Cut whole(const Node& node) const { return {cost_of(node), {{node.begin, node.end, node.sum}}}; }

  Cut better(const Node& node, Cut left, Cut right) const {
    const double cost = cost_of(node);
    if (cost <= left.cost + right.cost) return {cost, {{node.begin, node.end, node.sum}}};
    left.cost += right.cost;
    left.groups.insert(left.groups.end(), right.groups.begin(), right.groups.end());
    return left;
  }

  Cut grow(const Node& node) {
    if (is_whole(node)) return whole(node);
    const std::array<Node, 2> halves = cut(node);
    return better(node, grow(halves[0]), grow(halves[1]));
  }

  static glm::vec3 middle_of(const TreeItem& item) { return item.box.min * 0.5f + item.box.max * 0.5f; }

  /// Where middles are cut into bins: along each axis that is not flat, or the bins would be slabs.
  struct Cuts {
    glm::vec3 least;
    glm::vec3 bins_per_unit;  ///< 0 for a flat axis: all in its first bin

    std::array<std::size_t, 3> operator()(const glm::vec3& middle) const {
      const glm::vec3 at = (middle - least) * bins_per_unit;
      const auto bin = [](float place) { return std::min(bins - 1, static_cast<std::size_t>(place)); };
      return {bin(at.x), bin(at.y), bin(at.z)};
    }
  };

  struct Border {
    double drawn = infinity;  ///< entries, expected, if both sides were groups
    std::size_t axis = 0, bin = 0;
    GroupSum before, behind;
  };

  /// The best place to cut along an axis, if it is better than one found before.
  void find_border(const std::array<GroupSum, bins>& sums, std::size_t axis, Border& best) const {
    std::array<GroupSum, bins> behind;
    GroupSum sum;
    for (std::size_t b = bins; b-- > 1;) {
      sum.add(sums[b]);
      behind[b] = sum;
    }
    sum = {};
    for (std::size_t b = 1; b < bins; ++b) {
      sum.add(sums[b - 1]);
      if (sum.instances == 0 || behind[b].instances == 0) continue;
      const double drawn = seen_boxes_(sum.box) * static_cast<double>(sum.indices) +
                           seen_boxes_(behind[b].box) * static_cast<double>(behind[b].indices);
      if (drawn < best.drawn) best = {drawn, axis, b, sum, behind[b]};
    }
  }

  /// Parts the node's items in two.
  std::array<Node, 2> cut(const Node& node) {
    const std::span<TreeItem> own = items_.subspan(node.begin, node.end - node.begin);
    Box<glm::vec3> middles;
    for (const TreeItem& item : own) middles.add(middle_of(item));
    const glm::vec3 extent = middles.max - middles.min;
    const float longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0) || node.depth >= cut_by_halves) return cut_by_number(node);
    Cuts cuts{middles.min, glm::vec3(0)};
    for (int axis = 0; axis < 3; ++axis) {
      if (extent[axis] * 16 >= longest) cuts.bins_per_unit[axis] = static_cast<float>(bins) / extent[axis];
    }

    std::array<std::array<GroupSum, bins>, 3> sums{};
    for (const TreeItem& item : own) {
      const std::array<std::size_t, 3> at = cuts(middle_of(item));
      const GroupSum sum = item.sum();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (cuts.bins_per_unit[static_cast<int>(axis)] > 0) sums[axis][at[axis]].add(sum);
      }
    }
    Border best;
    for (std::size_t axis = 0; axis < 3; ++axis) find_border(sums[axis], axis, best);
    if (best.drawn == infinity) return cut_by_number(node);

    std::vector<TreeItem> second;
    second.reserve(best.behind.instances);
    std::size_t first = 0;
    for (const TreeItem& item : own) {
      if (cuts(middle_of(item))[best.axis] < best.bin) {
        own[first++] = item;
      } else {
        second.push_back(item);
      }
    }
    std::ranges::copy(second, own.begin() + static_cast<std::ptrdiff_t>(first));
    const std::size_t middle = node.begin + first;
    return {Node{node.begin, middle, node.depth + 1, best.before, {}, {}},
            Node{middle, node.end, node.depth + 1, best.behind, {}, {}}};
  }

  std::span<TreeItem> items_;
  const SeenBoxes& seen_boxes_;
  const GroupOptions& options_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> tasks_;
  std::vector<Cut> cuts_;
};

}  // namespace

std::vector<TreeGroup> tree_groups(std::span<TreeItem> items, const SeenBoxes& seen_boxes, const GroupOptions& options,
                                   const Executor& executor) {
  if (items.empty()) return {};
  Builder builder(items, seen_boxes, options);
  builder.plant();
  executor.for_each(builder.task_count(), [&](std::size_t task) { builder.run(task); });
  return builder.harvest();
}

}  // namespace foredraw::processors::merge_instances
