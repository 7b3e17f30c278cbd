#pragma once
// Choices of ways drawn at random, and what is exactly the best of them, found without anything of ours.

#include <foredraw/base/random.h>
#include <foredraw/runtime/lod_select.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace foredraw::testing {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
using Ways = std::vector<foredraw_lod_way>;

inline bool alike(const foredraw_lod_way& a, const foredraw_lod_way& b) {
  return a.cost == b.cost && a.benefit == b.benefit;
}
inline bool alike(const Ways& a, const Ways& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) { return alike(one, other); });
}

/// What is chosen of some objects, and the way of each.
struct Choice {
  foredraw_lod_result result{};
  std::vector<std::uint32_t> chosen;
  Ways ways;  ///< of the objects that have any

  bool adds_up() const {
    std::uint64_t cost = 0, benefit = 0;
    for (const foredraw_lod_way& way : ways) {
      cost += way.cost;
      benefit += way.benefit;
    }
    return cost == result.cost && benefit == result.benefit;
  }
};

/// Objects as C has them.
class Flat {
 public:
  explicit Flat(const std::vector<Ways>& objects) : first_{0} {
    for (const Ways& ways : objects) {
      ways_.insert(ways_.end(), ways.begin(), ways.end());
      first_.push_back(static_cast<std::uint32_t>(ways_.size()));
    }
  }

  foredraw_lod_scene scene() const {
    return {static_cast<std::uint32_t>(first_.size() - 1), first_.data(), ways_.data()};
  }

  /// method(scene, chosen) -> result, from that choice on.
  template <class Method>
  Choice choose(Method method, std::vector<std::uint32_t> chosen = {}) const {
    const foredraw_lod_scene all = scene();
    Choice choice{{}, std::move(chosen), {}};
    choice.chosen.resize(all.objects, 0);
    choice.result = method(&all, choice.chosen.data());
    for (std::uint32_t i = 0; i < all.objects; ++i) {
      if (first_[i] < first_[i + 1]) choice.ways.push_back(ways_.at(first_[i] + choice.chosen[i]));
    }
    return choice;
  }

 private:
  std::vector<std::uint32_t> first_;
  Ways ways_;
};

inline Choice selected(const std::vector<Ways>& objects, std::uint64_t budget) {
  return Flat(objects).choose([&](const foredraw_lod_scene* scene, std::uint32_t* chosen) {
    std::vector<std::uint64_t> memory(foredraw_lod_memory(scene) / 8 + 1);
    return foredraw_lod_select(scene, budget, chosen, memory.data());
  });
}

/// The cheapest way, of these the best; the object has one.
inline foredraw_lod_way cheapest_of(const Ways& ways) {
  return *std::ranges::min_element(ways, [](const foredraw_lod_way& a, const foredraw_lod_way& b) {
    return std::pair(a.cost, ~a.benefit) < std::pair(b.cost, ~b.benefit);
  });
}

inline std::pair<std::uint64_t, std::uint64_t> least_of(const std::vector<Ways>& objects) {
  std::pair<std::uint64_t, std::uint64_t> sum{0, 0};
  for (const Ways& ways : objects) {
    if (ways.empty()) continue;
    sum.first += cheapest_of(ways).cost;
    sum.second += cheapest_of(ways).benefit;
  }
  return sum;
}

/// The most benefit within the budget: all sums of costs and benefits, object after object, but those that another one
/// is as good as.
inline std::optional<std::uint64_t> best_of(const std::vector<Ways>& objects, std::uint64_t budget) {
  using Sum = std::pair<std::uint64_t, std::uint64_t>;
  std::vector<Sum> sums{{0, 0}}, more;
  for (const Ways& ways : objects) {
    if (ways.empty()) continue;
    more.clear();
    for (const Sum& sum : sums) {
      for (const foredraw_lod_way& way : ways) {
        if (sum.first + way.cost <= budget) more.emplace_back(sum.first + way.cost, sum.second + way.benefit);
      }
    }
    std::ranges::sort(
        more, [](const Sum& a, const Sum& b) { return std::pair(a.first, ~a.second) < std::pair(b.first, ~b.second); });
    sums.clear();
    for (const Sum& sum : more) {
      if (sums.empty() || sum.second > sums.back().second) sums.push_back(sum);
    }
    if (sums.empty()) return std::nullopt;
  }
  return sums.back().second;
}

/// The same by trying everything.
inline std::optional<std::uint64_t> best_by_trying(const std::vector<Ways>& objects, std::uint64_t budget,
                                                   std::size_t object = 0) {
  if (object == objects.size()) return 0;
  if (objects[object].empty()) return best_by_trying(objects, budget, object + 1);
  std::optional<std::uint64_t> best;
  for (const foredraw_lod_way& way : objects[object]) {
    if (way.cost > budget) continue;
    const auto rest = best_by_trying(objects, budget - way.cost, object + 1);
    if (rest && (!best || *rest + way.benefit > *best)) best = *rest + way.benefit;
  }
  return best;
}

/// The same by a table over costs, for many objects whose ways cost little.
inline std::optional<std::uint64_t> best_by_costs(const std::vector<Ways>& objects, std::uint64_t budget) {
  std::vector<std::int64_t> best(budget + 1, 0), next(budget + 1);  // [what is spent at most]; -1: impossible
  for (const Ways& ways : objects) {
    if (ways.empty()) continue;
    std::ranges::fill(next, -1);
    for (const foredraw_lod_way& way : ways) {
      for (std::uint64_t spent = way.cost; spent <= budget; ++spent) {
        if (best[spent - way.cost] >= 0) next[spent] = std::max(next[spent], best[spent - way.cost] + way.benefit);
      }
    }
    std::swap(best, next);
  }
  return best[budget] < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(best[budget]));
}

/// Without ways that cost more than what the others' cheapest leave of the budget, which is enough for all cheapest.
inline std::vector<Ways> affordable(std::vector<Ways> objects, std::uint64_t budget) {
  const std::uint64_t more = budget - least_of(objects).first;
  for (Ways& ways : objects) {
    if (ways.empty()) continue;
    const std::uint64_t most = cheapest_of(ways).cost + more;
    std::erase_if(ways, [&](const foredraw_lod_way& way) { return way.cost > most; });
  }
  return objects;
}

/// The most benefit within the budget where ways may be mixed: by duality the least of
/// price * budget + the sum of max(benefit - price * cost), which is found at the price between two ways of an object.
inline cpp_rational best_of_mixed(const std::vector<Ways>& objects, std::uint64_t budget) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> prices{{0, 1}};  // benefit for cost
  for (const Ways& ways : objects) {
    for (const foredraw_lod_way& a : ways) {
      for (const foredraw_lod_way& b : ways) {
        if (b.cost > a.cost && b.benefit > a.benefit) prices.emplace_back(b.benefit - a.benefit, b.cost - a.cost);
      }
    }
  }
  for (auto& [benefit, cost] : prices) {
    const std::uint64_t common = std::gcd(benefit, cost);
    benefit /= common;
    cost /= common;
  }
  std::ranges::sort(prices);
  prices.erase(std::unique(prices.begin(), prices.end()), prices.end());
  std::optional<cpp_rational> least;
  for (const auto& [benefit, cost] : prices) {
    __int128 sum = static_cast<__int128>(benefit) * budget;  // cost times what it is
    for (const Ways& ways : objects) {
      std::optional<__int128> most;
      for (const foredraw_lod_way& way : ways) {
        const __int128 worth = static_cast<__int128>(cost) * way.benefit - static_cast<__int128>(benefit) * way.cost;
        if (!most || worth > *most) most = worth;
      }
      sum += most.value_or(0);
    }
    const cpp_rational value{cpp_int(sum), cpp_int(cost)};
    if (!least || value < *least) least = value;
  }
  return *least;
}

inline cpp_int rounded_up(const cpp_rational& value) {  // above 0
  return (numerator(value) + denominator(value) - 1) / denominator(value);
}

inline void shuffle(auto& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

/// Few costs and benefits, so that many are equal or 0, or many; benefits that rise with costs, less and less or in
/// jumps, or at random; some ways twice, and some objects many times.
inline std::vector<Ways> drawn_objects(Random& random, std::size_t most_objects, std::size_t most_ways) {
  const std::uint64_t costs = random.below(2) ? 4 : 1000, benefits = random.below(2) ? 4 : 100000;
  const std::uint64_t shape = random.below(4), sequence = random.below(3), copies = random.below(2);
  std::vector<Ways> objects(1 + random.below(most_objects));
  for (Ways& ways : objects) {
    if (copies && random.below(3) != 0 && !objects.front().empty()) {
      ways = objects.front();  // and what it gains ties
      continue;
    }
    const std::size_t n = 1 + random.below(most_ways);
    std::vector<std::uint64_t> of_cost(n), of_benefit(n);
    for (std::size_t w = 0; w < n; ++w) {
      of_cost[w] = random.below(costs);
      of_benefit[w] = shape == 3 && random.below(2) ? 0 : random.below(benefits);
    }
    if (shape < 2) {
      std::ranges::sort(of_cost);
      std::ranges::sort(of_benefit);
    }
    if (shape == 1) {  // steps that gain less and less
      for (std::size_t w = 1; w < n; ++w) of_benefit[w] = of_benefit[w - 1] + (of_benefit[0] >> w);
    }
    for (std::size_t w = 0; w < n; ++w)
      ways.push_back({static_cast<std::uint32_t>(of_cost[w]), static_cast<std::uint32_t>(of_benefit[w])});
    if (n > 1 && random.below(8) == 0) ways[random.below(n)] = ways[random.below(n)];
    if (sequence == 1) std::ranges::reverse(ways);
    if (sequence == 2) shuffle(ways, random);
  }
  return objects;
}

/// Nothing, less than the cheapest, all but the least, the sum of some choice, the most and more, or anything between.
inline std::uint64_t drawn_budget(const std::vector<Ways>& objects, Random& random) {
  const std::uint64_t least = least_of(objects).first;
  std::uint64_t some = 0, most = 0;
  for (const Ways& ways : objects) {
    if (ways.empty()) continue;
    some += ways[random.below(ways.size())].cost;
    most += std::ranges::max(ways, {}, &foredraw_lod_way::cost).cost;
  }
  switch (random.below(12)) {
    case 0: return random.below(least + 1);
    case 1: return random.below(2) ? 0 : UINT64_MAX;
    case 2: return least;
    case 3: return most + random.below(3) - (most > 0);
    case 4:
    case 5: return some;
    default: return least + random.below(most - least + 1);
  }
}

}  // namespace foredraw::testing
