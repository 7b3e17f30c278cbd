#include "k_orders.h"

#include "piece_order.h"

#include <foredraw/analysis/view_directions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

using Sequences = std::vector<std::vector<std::uint32_t>>;  // [draw][place] = atom

/// What a picture of the node counts: a mean over pictures, however much of them is covered, so that none is neglected.
std::int64_t weight_of_pixel(const SeenSubject& subject, std::size_t node) {
  constexpr double picture = 0x1p32;
  const auto visible = static_cast<double>(subject.layers.views[node].always.visible);
  return visible > 0 ? static_cast<std::int64_t>(std::floor(picture * subject.weights[node] / visible)) : 0;
}

class Alternation {
 public:
  Alternation(const SeenSubject& subject, const KOrdersOptions& options, const Executor& executor)
      : subject_(subject), options_(options), executor_(executor), k_(static_cast<std::size_t>(options.k)) {
    for (std::size_t node = 0; node < nodes(); ++node) weights_.push_back(weight_of_pixel(subject, node));
  }

  KOrders run() {
    if (k_ > 1) part_by_direction();
    else serving_.assign(nodes(), 0);
    std::uint64_t least = ~std::uint64_t{0};
    for (int round = 0; k_ > 1 && round < options_.rounds; ++round) {
      const std::vector<Sequences> orders = made(1.0e30);
      const std::uint64_t cost = serve(orders);
      if (cost + cost / 1000 >= least) break;
      least = cost;
    }
    KOrders result;
    result.orders = made(options_.acmr_budget);
    serve(result.orders);
    result.serving = serving_;
    result.counts = counts_;
    put_best_first(result);
    return result;
  }

 private:
  std::size_t nodes() const { return subject_.layers.views.size(); }

  void part_by_direction() {
    const Directions middles = turned_at_random(fibonacci_directions(k_), options_.seed);
    for (const glm::dvec3& direction : subject_.directions) {
      std::size_t nearest = 0;
      for (std::size_t j = 1; j < k_; ++j) {
        if (glm::dot(middles[j], direction) > glm::dot(middles[nearest], direction)) nearest = j;
      }
      serving_.push_back(static_cast<std::uint8_t>(nearest));
    }
  }

  /// Orders for the nodes that each serves.
  std::vector<Sequences> made(double budget) const {
    std::vector<std::uint32_t> pieces;
    for (const AtomicDraw& draw : subject_.draws) pieces.push_back(static_cast<std::uint32_t>(draw.atoms.count()));
    OcclusionOrderOptions options = options_;
    options.acmr_budget = budget;
    std::vector<Sequences> orders(k_, Sequences(subject_.draws.size()));
    executor_.for_each(k_, [&](std::size_t j) {
      std::vector<WeightedLayers> served;
      for (std::size_t node = 0; node < nodes(); ++node) {
        if (serving_[node] == j) served.push_back({&subject_.layers.views[node], weights_[node]});
      }
      std::vector<Occlusions> occlusions = occlusions_of(served, subject_.owners, pieces);
      executor_.for_each(subject_.draws.size(), [&](std::size_t d) {
        orders[j][d] = occlusion_order(subject_.draws[d], std::move(occlusions[d]), options);
      });
    });
    return orders;
  }

  /// Gives every node to the order that draws least there. What all of them cost then.
  std::uint64_t serve(const std::vector<Sequences>& orders) {
    std::vector<std::vector<OverdrawCount>> counts(orders.size());
    executor_.for_each(orders.size(), [&](std::size_t j) { counts[j] = counts_of(subject_, orders[j]); });
    counts_.resize(nodes());
    std::uint64_t cost = 0;
    for (std::size_t node = 0; node < nodes(); ++node) {
      std::size_t best = 0;
      for (std::size_t j = 1; j < counts.size(); ++j) {
        if (counts[j][node].shaded < counts[best][node].shaded) best = j;
      }
      serving_[node] = static_cast<std::uint8_t>(best);
      counts_[node] = counts[best][node];
      cost += static_cast<std::uint64_t>(weights_[node]) * (counts_[node].shaded - counts_[node].visible);
    }
    return cost;
  }

  void put_best_first(KOrders& result) const {
    std::vector<std::uint64_t> costs(k_, 0);
    executor_.for_each(k_, [&](std::size_t j) {
      const std::vector<OverdrawCount> counts = counts_of(subject_, result.orders[j]);
      for (std::size_t node = 0; node < nodes(); ++node) {
        costs[j] += static_cast<std::uint64_t>(weights_[node]) * (counts[node].shaded - counts[node].visible);
      }
    });
    const auto best = static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin());
    std::swap(result.orders[0], result.orders[best]);
    for (std::uint8_t& order : result.serving) order = order == 0 ? best : order == best ? 0 : order;
  }

  const SeenSubject& subject_;
  const KOrdersOptions& options_;
  const Executor& executor_;
  std::size_t k_;
  std::vector<std::int64_t> weights_;  // [node] of a pixel
  std::vector<std::uint8_t> serving_;
  std::vector<OverdrawCount> counts_;
};

}  // namespace

std::vector<OverdrawCount> counts_of(const SeenSubject& subject, std::span<const Sequences::value_type> atoms) {
  std::vector<std::uint32_t> order;
  order.reserve(subject.owners.size());
  for (std::size_t first = 0; first < subject.owners.size();) {
    const std::vector<std::uint32_t>& sequence = atoms[subject.owners[first].draw];
    for (const std::uint32_t atom : sequence) order.push_back(static_cast<std::uint32_t>(first) + atom);
    first += sequence.size();
  }
  return count_overdraw_by_view(subject.layers, order);
}

KOrders k_orders(const SeenSubject& subject, const KOrdersOptions& options, const Executor& executor) {
  return Alternation(subject, options, executor).run();
}

}  // namespace foredraw
