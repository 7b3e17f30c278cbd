// Boxes are split where rays are expected to test least; for what is nearest that serves as well.
// I. Wald: On fast Construction of SAH-based Bounding Volume Hierarchies, IEEE Symposium on Interactive Ray Tracing,
// 2007.

#include <foredraw/analysis/box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace foredraw {

namespace {

constexpr std::size_t box_bins = 16;
constexpr std::size_t deepest_by_area = 24;  // from there on by halves: the tree stays shallow

class BoxTreeBuilder {
 public:
  BoxTreeBuilder(BoxTree& tree, std::span<const BoxTree::Box> boxes, std::size_t most_in_leaf)
      : tree_(tree), most_in_leaf_(most_in_leaf) {
    leaves_.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      leaves_.push_back({boxes[i], 0.5f * boxes[i].min + 0.5f * boxes[i].max, i});
    }
    if (leaves_.empty()) return;
    tree_.nodes.reserve(leaves_.size() / (2 * most_in_leaf_) + 1);
    add_node({0, leaves_.size(), box_of(0, leaves_.size())}, 0);
    tree_.order.reserve(leaves_.size());
    for (const Leaf& leaf : leaves_) tree_.order.push_back(leaf.number);
  }

 private:
  using Box = BoxTree::Box;
  static constexpr std::size_t width = BoxTree::width;

  struct Leaf {
    Box box;
    glm::vec3 middle;
    std::uint32_t number;
  };
  struct Range {
    std::size_t begin, end;
    Box box;
    std::size_t count() const { return end - begin; }
  };

  Box box_of(std::size_t begin, std::size_t end) const {
    Box box;
    for (std::size_t i = begin; i < end; ++i) box.add(leaves_[i].box);
    return box;
  }

  std::uint32_t add_node(const Range& whole, std::size_t depth) {
    std::array<Range, width> children{whole};
    std::size_t count = 1;
    for (; count < width; ++count) {
      const auto largest = std::max_element(children.begin(), children.begin() + count,
                                            [&](const Range& a, const Range& b) { return area(a) < area(b); });
      if (largest->count() <= most_in_leaf_) break;
      const std::size_t at = depth < deepest_by_area ? part_by_area(*largest) : halve(*largest);
      children[count] = {at, largest->end, box_of(at, largest->end)};
      *largest = {largest->begin, at, box_of(largest->begin, at)};
    }
    const auto number = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.emplace_back();
    for (std::size_t c = 0; c < width; ++c) {
      const Range& child = c < count ? children[c] : Range{0, 0, {}};
      const bool is_leaf = child.count() <= most_in_leaf_;
      const auto first = is_leaf ? static_cast<std::uint32_t>(child.begin) : add_node(child, depth + 1);
      BoxTree::Node& node = tree_.nodes[number];
      node.first[c] = first;
      node.count[c] = is_leaf ? static_cast<std::uint32_t>(child.count()) : 0;
      for (int axis = 0; axis < 3; ++axis) {
        node.planes[0][axis][c] = child.box.min[axis];
        node.planes[1][axis][c] = child.box.max[axis];
      }
    }
    return number;
  }

  /// What is no leaf yet is opened first where rays are likeliest.
  double area(const Range& range) const { return range.count() <= most_in_leaf_ ? -1 : half_area(range.box); }

  Box middles(const Range& range) const {
    Box box;
    for (std::size_t i = range.begin; i < range.end; ++i) box.add(leaves_[i].middle);
    return box;
  }

  static int longest_axis(const Box& box) {
    const glm::vec3 size = box.max - box.min;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  /// Parts the range by the plane across the longest axis of its middles that makes the sum of area * triangles least.
  /// Where the second part begins.
  std::size_t part_by_area(const Range& range) {
    const Box at = middles(range);
    const int axis = longest_axis(at);
    const float scale = static_cast<float>(box_bins) / (at.max[axis] - at.min[axis]);
    if (!std::isfinite(scale)) return halve(range);
    const auto bin_of = [&](const Leaf& leaf) {
      return std::min(box_bins - 1, static_cast<std::size_t>((leaf.middle[axis] - at.min[axis]) * scale));
    };
    std::array<Box, box_bins> boxes;
    std::array<std::size_t, box_bins> counts{};
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const std::size_t bin = bin_of(leaves_[i]);
      boxes[bin].add(leaves_[i].box);
      ++counts[bin];
    }
    std::array<double, box_bins> behind{};  // [bin] what it and those after it cost
    Box box;
    std::size_t count = 0;
    for (std::size_t bin = box_bins; bin-- > 1;) {
      box.add(boxes[bin]);
      count += counts[bin];
      behind[bin] = half_area(box) * static_cast<double>(count);
    }
    box = {};
    count = 0;
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t bin = 1; bin < box_bins; ++bin) {
      box.add(boxes[bin - 1]);
      count += counts[bin - 1];
      const double cost = half_area(box) * static_cast<double>(count) + behind[bin];
      if (count == 0 || count == range.count() || cost >= least) continue;
      least = cost;
      best = bin;
    }
    if (best == 0) return halve(range);
    const auto begin = leaves_.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto end = leaves_.begin() + static_cast<std::ptrdiff_t>(range.end);
    return static_cast<std::size_t>(std::partition(begin, end, [&](const Leaf& leaf) { return bin_of(leaf) < best; }) -
                                    leaves_.begin());
  }

  std::size_t halve(const Range& range) {
    const int axis = longest_axis(middles(range));
    const std::size_t half = range.begin + range.count() / 2;
    std::nth_element(leaves_.begin() + static_cast<std::ptrdiff_t>(range.begin),
                     leaves_.begin() + static_cast<std::ptrdiff_t>(half),
                     leaves_.begin() + static_cast<std::ptrdiff_t>(range.end), [&](const Leaf& a, const Leaf& b) {
                       return std::pair(a.middle[axis], a.number) < std::pair(b.middle[axis], b.number);
                     });
    return half;
  }

  BoxTree& tree_;
  std::size_t most_in_leaf_;
  std::vector<Leaf> leaves_;
};

}  // namespace

BoxTree box_tree(std::span<const BoxTree::Box> boxes, std::size_t most_in_leaf) {
  BoxTree tree;
  BoxTreeBuilder(tree, boxes, most_in_leaf);
  return tree;
}

}  // namespace foredraw
