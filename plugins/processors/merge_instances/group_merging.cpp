#include "group_merging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace foredraw::processors::merge_instances {

namespace {

constexpr std::uint32_t gone = ~std::uint32_t{0};
constexpr std::size_t most_neighbours = 32;
constexpr int most_in_a_row = 64;  ///< groups looked at in three cells: bounds the time where most lie in a few cells

struct Pair {
  double saves = 0;
  std::uint32_t a = 0, b = 0;
  /// The top of a queue saves most; of equals, the first ones.
  bool operator<(const Pair& other) const {
    if (saves != other.saves) return saves < other.saves;
    return a != other.a ? a > other.a : b > other.b;
  }
};

/// Groups by the cell that their middle lies in, about one to a cell.
class Cells {
 public:
  explicit Cells(std::span<const GroupSum> groups) {
    Box<glm::vec3> all;
    for (const GroupSum& group : groups) all.add(middle_of(group));
    least_ = all.min;
    const glm::vec3 extent = all.max - all.min;
    const float longest = std::max({extent.x, extent.y, extent.z});
    // As if the groups filled the two longer sides.
    const float along = std::max(1.0f, std::floor(std::sqrt(static_cast<float>(groups.size()))));
    side_ = longest > 0 ? longest / along : 1.0f;
    for (std::uint32_t g = 0; g < groups.size(); ++g) places_.push_back({cell_of(middle_of(groups[g])), g});
    std::ranges::sort(places_);
  }

  /// Those in the cells around, the group itself among them, in a fixed sequence.
  std::vector<std::uint32_t> around(const GroupSum& group) const {
    std::vector<std::uint32_t> found;
    const std::array<std::int32_t, 3> at = cell_of(middle_of(group));
    for (std::int32_t x = -1; x <= 1; ++x) {
      for (std::int32_t y = -1; y <= 1; ++y) {
        const Place first{{at[0] + x, at[1] + y, at[2] - 1}, 0};
        const Place behind{{at[0] + x, at[1] + y, at[2] + 2}, 0};
        auto it = std::ranges::lower_bound(places_, first);
        const auto end = std::lower_bound(it, places_.end(), behind);
        for (int i = 0; i < most_in_a_row && it != end; ++i, ++it) found.push_back(it->group);
      }
    }
    return found;
  }

 private:
  struct Place {
    std::array<std::int32_t, 3> cell;
    std::uint32_t group = 0;
    auto operator<=>(const Place&) const = default;
  };

  static glm::vec3 middle_of(const GroupSum& group) { return group.box.min * 0.5f + group.box.max * 0.5f; }
  std::array<std::int32_t, 3> cell_of(const glm::vec3& point) const {
    const glm::vec3 at = (point - least_) / side_;
    return {static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y), static_cast<std::int32_t>(at.z)};
  }

  glm::vec3 least_{0};
  float side_ = 1;
  std::vector<Place> places_;
};

class Merging {
 public:
  Merging(std::span<const GroupSum> groups, const SeenBoxes& seen_boxes, const GroupOptions& options)
      : seen_boxes_(seen_boxes),
        options_(options),
        sums_(groups.begin(), groups.end()),
        into_(groups.size(), gone),
        neighbours_(groups.size()) {
    for (const GroupSum& sum : sums_) seen_.push_back(seen_boxes_(sum.box));
    const Cells cells(groups);
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
      std::vector<Pair> pairs;
      for (const std::uint32_t other : cells.around(sums_[g])) {
        if (other != g) pairs.push_back({saved(g, other), other, 0});
      }
      std::ranges::sort(pairs, [](const Pair& a, const Pair& b) { return b < a; });
      pairs.resize(std::min(pairs.size(), most_neighbours));
      for (const Pair& pair : pairs) neighbours_[g].push_back(pair.a);
      for (const Pair& pair : pairs) offer(g, pair.a, pair.saves);
    }
  }

  void run() {
    while (!queue_.empty()) {
      const Pair pair = queue_.top();
      queue_.pop();
      if (into_[pair.a] != gone || into_[pair.b] != gone) continue;
      join(pair.a, pair.b);
    }
  }

  std::uint32_t last_of(std::uint32_t group) const {
    while (into_[group] != gone) group = into_[group];
    return group;
  }

 private:
  double saved(std::uint32_t a, std::uint32_t b) const {
    GroupSum both = sums_[a];
    both.add(sums_[b]);
    if (!both.is_within(options_)) return -1;
    const double seen = seen_boxes_(both.box);
    return options_.draw_cost - (seen - seen_[a]) * static_cast<double>(sums_[a].indices) -
           (seen - seen_[b]) * static_cast<double>(sums_[b].indices);
  }

  void offer(std::uint32_t a, std::uint32_t b, double saves) {
    if (saves > 0) queue_.push({saves, std::min(a, b), std::max(a, b)});
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const auto made = static_cast<std::uint32_t>(sums_.size());
    GroupSum both = sums_[a];
    both.add(sums_[b]);
    sums_.push_back(both);
    seen_.push_back(seen_boxes_(both.box));
    into_[a] = into_[b] = made;
    into_.push_back(gone);
    std::vector<std::uint32_t> around;
    for (const std::uint32_t part : {a, b}) {
      for (const std::uint32_t other : neighbours_[part]) around.push_back(last_of(other));
    }
    std::ranges::sort(around);
    around.erase(std::unique(around.begin(), around.end()), around.end());
    std::erase(around, made);
    for (const std::uint32_t other : around) {
      offer(made, other, saved(made, other));
      neighbours_[other].push_back(made);
    }
    neighbours_.push_back(std::move(around));
  }

  const SeenBoxes& seen_boxes_;
  const GroupOptions& options_;
  std::vector<GroupSum> sums_;
  std::vector<double> seen_;         ///< of each group's box
  std::vector<std::uint32_t> into_;  ///< the group that it became part of
  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::priority_queue<Pair> queue_;
};

}  // namespace

std::vector<std::uint32_t> merged_neighbours(std::span<const GroupSum> groups, const SeenBoxes& seen_boxes,
                                             const GroupOptions& options) {
  Merging merging(groups, seen_boxes, options);
  merging.run();
  std::vector<std::uint32_t> number(2 * groups.size(), gone), result;
  std::uint32_t next = 0;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    std::uint32_t& of_last = number[merging.last_of(g)];
    if (of_last == gone) of_last = next++;
    result.push_back(of_last);
  }
  return result;
}

}  // namespace foredraw::processors::merge_instances
