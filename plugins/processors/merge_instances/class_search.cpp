#include "class_search.h"

#include <algorithm>
#include <array>
#include <limits>

namespace foredraw::processors::merge_instances {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::uint32_t most_classes = 4;
constexpr std::uint64_t steps_of_a_look = 32;  ///< for each mesh, about

/// A tree over the candidates: the leaves are candidates, and a node holds for each mesh the least cost below it.
class RangeTree {
 public:
  RangeTree(std::span<const MeshSize> sizes, std::vector<std::uint32_t> candidates, const Prices& prices)
      : candidates_(std::move(candidates)), meshes_(sizes.size()) {
    leaves_ = 1;
    while (leaves_ < candidates_.size()) leaves_ *= 2;
    costs_.assign(2 * leaves_ * meshes_, unbounded);
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      double* row = costs_.data() + (leaves_ + c) * meshes_;
      for (std::size_t m = 0; m < meshes_; ++m) row[m] = cost_of(sizes[m], candidates_[c], prices);
    }
    for (std::size_t node = leaves_; --node > 0;) {
      double* row = costs_.data() + node * meshes_;
      const double* left = costs_.data() + 2 * node * meshes_;
      const double* right = left + meshes_;
      for (std::size_t m = 0; m < meshes_; ++m) row[m] = std::min(left[m], right[m]);
    }
  }

  bool is_leaf(std::uint64_t node) const { return node >= leaves_; }
  /// Whether any candidate is below it.
  bool holds_any(std::uint32_t node) const {
    std::size_t first = node;
    while (first < leaves_) first *= 2;
    return first - leaves_ < candidates_.size();
  }
  std::uint32_t frequency(std::uint32_t leaf) const { return candidates_[leaf - leaves_]; }
  std::uint32_t leaf_of(std::size_t candidate) const { return static_cast<std::uint32_t>(leaves_ + candidate); }
  std::size_t candidate_count() const { return candidates_.size(); }
  std::size_t mesh_count() const { return meshes_; }
  const double* row(std::uint32_t node) const { return costs_.data() + node * meshes_; }

 private:
  std::vector<std::uint32_t> candidates_;
  std::size_t meshes_;
  std::size_t leaves_;
  std::vector<double> costs_;  ///< [node][mesh]
};

/// One range of candidates for each class, none before the one in front of it.
using Ranges = std::array<std::uint32_t, most_classes>;

class Search {
 public:
  Search(const RangeTree& tree, std::uint32_t classes, std::uint64_t most_steps)
      : tree_(tree), classes_(classes), most_steps_(most_steps) {}

  /// Looks at every choice below a cost in place of keeping the best.
  void look_at(double below, std::function<double(const Ranges&)> look) {
    best_ = below;
    look_ = std::move(look);
  }

  void begin_with(const Ranges& leaves) {
    const double cost = bound(leaves, unbounded);
    if (cost < best_) take(leaves, cost);
  }

  void run() {
    Ranges all{};
    std::fill_n(all.begin(), classes_, 1u);
    visit(all, bound(all, best_));
  }

  /// From a choice, moves one class after the other to where it serves best, until none moves.
  Ranges improved(Ranges leaves) const {
    std::vector<double> others(tree_.mesh_count());
    for (bool moved = true; moved;) {
      moved = false;
      for (std::uint32_t k = 0; k < classes_; ++k) {
        std::ranges::fill(others, unbounded);
        for (std::uint32_t other = 0; other < classes_; ++other) {
          const double* row = tree_.row(leaves[other]);
          for (std::size_t m = 0; other != k && m < others.size(); ++m) others[m] = std::min(others[m], row[m]);
        }
        double least = sum_of_least(others.data(), tree_.row(leaves[k]));
        for (std::size_t c = 0; c < tree_.candidate_count(); ++c) {
          const double cost = sum_of_least(others.data(), tree_.row(tree_.leaf_of(c)));
          if (cost < least) {
            least = cost;
            leaves[k] = tree_.leaf_of(c);
            moved = true;
          }
        }
      }
    }
    return leaves;
  }

  const Ranges& found() const { return found_; }
  double cost() const { return best_; }
  bool came_to_its_end() const { return least_left_ == unbounded; }
  double least() const { return std::min(best_, least_left_); }

 private:
  /// Four sums, so that none waits for the other.
  double sum_of_least(const double* a, const double* b) const {
    std::array<double, 4> sums{};
    const std::size_t meshes = tree_.mesh_count();
    std::size_t m = 0;
    for (; m + 4 <= meshes; m += 4) {
      for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += std::min(a[m + lane], b[m + lane]);
    }
    for (; m < meshes; ++m) sums[0] += std::min(a[m], b[m]);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }

  /// What any choice from these ranges costs at least; of leaves, what they cost. Past `enough` any number above it.
  double bound(const Ranges& ranges, double enough) const {
    steps_ += tree_.mesh_count();
    if (classes_ == 1) return sum_of_least(tree_.row(ranges[0]), tree_.row(ranges[0]));
    if (classes_ == 2) return sum_of_least(tree_.row(ranges[0]), tree_.row(ranges[1]));
    double sum = 0;
    for (std::size_t m = 0; m < tree_.mesh_count() && sum <= enough; ++m) {
      double least = tree_.row(ranges[0])[m];
      for (std::uint32_t k = 1; k < classes_; ++k) least = std::min(least, tree_.row(ranges[k])[m]);
      sum += least;
    }
    return sum;
  }

  void take(const Ranges& leaves, double cost) {
    best_ = cost;
    found_ = leaves;
  }

  /// The least node of a class lies at the left, so of several that stand for the same range the highest is split: the
  /// numbers of nodes fall towards the root.
  void visit(const Ranges& ranges, double least) {
    if (least >= best_ * (1 - 1e-12)) return;
    if (steps_ > most_steps_) {
      least_left_ = std::min(least_left_, least);
      return;
    }
    std::uint32_t widest = 0;
    for (std::uint32_t k = 1; k < classes_; ++k) {
      if (ranges[k] < ranges[widest]) widest = k;
    }
    if (tree_.is_leaf(ranges[widest])) {
      if (look_) {
        steps_ += steps_of_a_look * tree_.mesh_count();
        best_ = std::min(best_, look_(ranges));
      } else {
        take(ranges, least);
      }
      return;
    }
    std::array<Ranges, 2> halves{ranges, ranges};
    std::array<double, 2> bounds{unbounded, unbounded};
    for (std::uint32_t side = 0; side < 2; ++side) {
      halves[side][widest] = 2 * ranges[widest] + side;
      if (tree_.holds_any(halves[side][widest]) && in_sequence(halves[side])) bounds[side] = bound(halves[side], best_);
    }
    const std::uint32_t first = bounds[1] < bounds[0] ? 1 : 0;
    visit(halves[first], bounds[first]);
    visit(halves[1 - first], bounds[1 - first]);
  }

  /// Whether some choice from the ranges is rising: the others are the same ones in another sequence.
  bool in_sequence(const Ranges& ranges) const {
    for (std::uint32_t k = 1; k < classes_; ++k) {
      std::uint64_t before = ranges[k - 1], at = ranges[k];
      while (!tree_.is_leaf(before)) before = 2 * before;  // the first leaf below it
      while (!tree_.is_leaf(at)) at = 2 * at + 1;          // the last one
      if (at < before) return false;
    }
    return true;
  }

  const RangeTree& tree_;
  std::uint32_t classes_;
  std::uint64_t most_steps_;
  mutable std::uint64_t steps_ = 0;
  Ranges found_{};
  double best_ = unbounded;
  double least_left_ = unbounded;
  std::function<double(const Ranges&)> look_;
};

/// Sequences of classes to begin with: the single best one, and others spread over the candidates by their number.
Ranges spread(const RangeTree& tree, std::uint32_t classes, std::size_t single, std::uint32_t variant) {
  Ranges leaves{};
  const std::size_t last = tree.candidate_count() - 1;
  leaves[0] = tree.leaf_of(variant == 0 ? single : last * variant / 5);
  for (std::uint32_t k = 1; k < classes; ++k) leaves[k] = tree.leaf_of(last * k / classes);
  return leaves;
}

std::vector<std::uint32_t> frequencies_of(const RangeTree& tree, const Ranges& leaves, std::uint32_t classes) {
  std::vector<std::uint32_t> frequencies;
  for (std::uint32_t k = 0; k < classes; ++k) frequencies.push_back(tree.frequency(leaves[k]));
  std::ranges::sort(frequencies);
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
  return frequencies;
}

/// Two classes are searched to the end, unless not all candidates are searched anyway.
std::uint64_t steps_for(std::uint32_t classes, bool all, std::uint64_t most_steps) {
  return classes <= 2 && all ? std::numeric_limits<std::uint64_t>::max() : most_steps;
}

/// The candidates that are searched. A tree of all of them may be too large where meshes are; then the smaller half of
/// those that there is room for stays whole, and of larger ones every so-many-th does.
struct Candidates {
  std::vector<std::uint32_t> frequencies;
  bool all = true;
};

constexpr std::size_t most_costs = 1'000'000;

Candidates searched_candidates(std::span<const MeshSize> sizes, std::uint32_t multiple, std::uint32_t always) {
  Candidates candidates{frequency_candidates(sizes, multiple, multiple, std::numeric_limits<std::uint32_t>::max())};
  std::vector<std::uint32_t>& all = candidates.frequencies;
  const std::size_t room = std::max<std::size_t>(64, most_costs / sizes.size());
  if (all.size() <= room) return candidates;
  candidates.all = false;
  std::vector<std::uint32_t> kept(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(room / 2));
  const std::size_t rest = all.size() - room / 2;
  for (std::size_t i = 1; i <= room / 2; ++i) kept.push_back(all[room / 2 - 1 + rest * i / (room / 2)]);
  kept.push_back(always);
  std::ranges::sort(kept);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  all = std::move(kept);
  return candidates;
}

/// One slot each and no padding: less is not to be had.
double one_slot_each(std::span<const MeshSize> sizes, const Prices& prices) {
  double cost = 0;
  for (const MeshSize& size : sizes) cost += static_cast<double>(size.placed) * prices.slot;
  return cost;
}

}  // namespace

ClassSearch search_classes(std::span<const MeshSize> sizes, std::uint32_t multiple, std::uint32_t classes,
                           const Prices& prices, std::uint64_t most_steps) {
  const std::uint32_t single = best_frequency(sizes, multiple, prices);
  Candidates candidates = searched_candidates(sizes, multiple, single);
  const auto single_place = static_cast<std::size_t>(std::ranges::lower_bound(candidates.frequencies, single) -
                                                     candidates.frequencies.begin());
  const RangeTree tree(sizes, std::move(candidates.frequencies), prices);
  Search search(tree, classes, steps_for(classes, candidates.all, most_steps));
  const std::uint32_t variants = candidates.all ? 4 : 1;
  for (std::uint32_t variant = 0; variant < variants; ++variant) {
    search.begin_with(search.improved(spread(tree, classes, single_place, variant)));
  }
  search.run();

  ClassSearch result;
  result.frequencies = frequencies_of(tree, search.found(), classes);
  result.cost = search.cost();
  result.bound = candidates.all ? search.least() : std::min(one_slot_each(sizes, prices), search.cost());
  return result;
}

bool visit_choices(std::span<const MeshSize> sizes, std::uint32_t multiple, std::uint32_t classes, const Prices& prices,
                   std::uint64_t most_steps, double below,
                   const std::function<double(std::span<const std::uint32_t>)>& look) {
  Candidates candidates = searched_candidates(sizes, multiple, best_frequency(sizes, multiple, prices));
  const RangeTree tree(sizes, std::move(candidates.frequencies), prices);
  Search search(tree, classes, most_steps);
  search.look_at(below, [&](const Ranges& leaves) { return look(frequencies_of(tree, leaves, classes)); });
  search.run();
  return candidates.all && search.came_to_its_end();
}

}  // namespace foredraw::processors::merge_instances
