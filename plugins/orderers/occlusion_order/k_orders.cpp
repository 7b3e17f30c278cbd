#include "k_orders.h"

#include "near_looks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

using Sequences = std::vector<std::vector<std::uint32_t>>;  // [draw][rank] = atom

/// Of a pixel of each look: every picture counts alike but for its weight, however much of it is covered.
std::vector<std::int64_t> weights_of_pixels(const SubjectLayers& subject) {
  constexpr double picture = 0x1p32;  // of the heaviest look: sums over all of them, 256 times each, stay below 2^63
  const double heaviest = subject.weights.empty() ? 1 : *std::ranges::max_element(subject.weights);
  std::vector<std::int64_t> weights;
  for (std::size_t look = 0; look < subject.weights.size(); ++look) {
    const auto visible = static_cast<double>(subject.layers.views[look].always.visible);
    const double weight = visible > 0 ? picture / visible * (subject.weights[look] / heaviest) : 0;
    weights.push_back(static_cast<std::int64_t>(std::floor(weight)));
  }
  return weights;
}

/// Those of every so-many-th pose, so that there are so many looks at most, but one pose at least.
std::vector<std::size_t> looks_of_some_poses(const SubjectLayers& subject, std::size_t most) {
  const std::size_t looks = subject.layers.views.size();
  const std::size_t step = (looks + most - 1) / most;
  std::vector<std::size_t> some;
  std::size_t pose = 0;
  for (std::size_t look = 0; look < looks; ++look) {
    if (look > 0 && subject.poses[look] != subject.poses[look - 1]) ++pose;
    if (pose % step == 0) some.push_back(look);
  }
  return some;
}

SubjectLayers with_looks(const SubjectLayers& subject, std::span<const std::size_t> looks) {
  SubjectLayers some{subject.draws, subject.owners, {}, {}, {}, {}};
  some.layers.owners = subject.layers.owners;
  for (const std::size_t look : looks) {
    some.layers.views.push_back(subject.layers.views[look]);
    some.directions.push_back(subject.directions[look]);
    some.weights.push_back(subject.weights[look]);
    some.poses.push_back(subject.poses[look]);
  }
  return some;
}

class Alternation {
 public:
  Alternation(const SubjectLayers& subject, const KOrdersOptions& options, const Executor& executor,
              const KSequences* sequences)
      : subject_(subject),
        sequences_(sequences),
        options_(options),
        executor_(executor),
        k_(static_cast<std::size_t>(options.k)),
        weights_(weights_of_pixels(subject)),
        near_(subject) {}

  KOrders run() {
    if (sequences_ != nullptr) first_serving_ = sequences_->serving;
    begin(0);
    if (k_ > 1) find_who_serves_what();
    KOrders result;
    result.orders = made(most_looks(options_.quality), options_.acmr_budget);
    serve(result.orders);
    result.serving = serving_;
    result.counts = counts_;
    if (sequences_ != nullptr) result.sequences = sequences_->sequences;
    put_best_first(result);
    return result;
  }

 private:
  std::size_t looks() const { return subject_.layers.views.size(); }

  /// Poses are much like their neighbours: of many, some tell it of all.
  void find_who_serves_what() {
    const std::size_t most = 2 * most_looks(options_.quality);
    if (looks() <= most || subject_.poses.empty()) {
      serving_ = best_of_all_starts();
      return;
    }
    const std::vector<std::size_t> chosen = looks_of_some_poses(subject_, most);
    const SubjectLayers some = with_looks(subject_, chosen);
    Alternation of_some(some, options_, executor_, sequences_);
    for (const std::size_t look : chosen) {
      if (!first_serving_.empty()) of_some.first_serving_.push_back(first_serving_[look]);
    }
    of_some.serving_ = of_some.best_of_all_starts();
    serve(of_some.made_without_budget());
  }

  std::vector<std::uint8_t> best_of_all_starts() {
    std::vector<std::uint8_t> best;
    std::uint64_t least = ~std::uint64_t{0};
    for (int start = 0; start <= options_.restarts; ++start) {
      begin(static_cast<std::uint64_t>(start));
      const std::uint64_t cost = alternate();
      if (cost >= least && !best.empty()) continue;
      least = cost;
      best = serving_;
    }
    return best;
  }

  /// While looks move, orders are made of fewer of them and without a budget: it is enough to tell who serves what.
  std::vector<Sequences> made_without_budget() const {
    return made(most_looks(options_.quality) / 4, std::numeric_limits<double>::infinity());
  }

  /// Until the cost falls no further; returns the last.
  std::uint64_t alternate() {
    std::uint64_t least = ~std::uint64_t{0};
    for (int round = 0; round < options_.rounds; ++round) {
      serve(made_without_budget());
      const std::uint64_t cost = cost_of(counts_);
      if (cost + cost / 100 >= least) return cost;
      least = cost;
      give_work_to_idle_orders();
    }
    return least;
  }

  /// That order j is drawn in.
  std::span<const std::uint32_t> sequence(std::size_t j) const {
    return sequences_ == nullptr ? std::span<const std::uint32_t>() : sequences_->sequences[j];
  }

  /// With what is known of who serves what; else with looks parted by direction.
  void begin(std::uint64_t start) {
    if (start == 0 && !first_serving_.empty()) {
      serving_ = first_serving_;
      return;
    }
    serving_ = parted_by_direction(subject_, k_, options_.seed + start);
  }

  /// Orders for the looks that each serves, made of so many of these.
  std::vector<Sequences> made(std::size_t most, double budget) const {
    std::vector<std::uint32_t> pieces;
    for (const AtomicDraw& draw : subject_.draws) pieces.push_back(static_cast<std::uint32_t>(draw.atoms.count()));
    OcclusionOrderOptions options = options_;
    options.acmr_budget = budget;
    const double vertices = static_cast<double>(vertices_as_it_came());
    std::vector<Sequences> orders(k_, Sequences(subject_.draws.size()));
    executor_.for_each(k_, [&](std::size_t j) {
      const std::vector<WeightedLayers> served = some_served_by(j, most);
      OcclusionOrderOptions of_order = options;
      of_order.vertex_cost = options_.vertex_weight * visible_in(served) / vertices;
      std::vector<Occlusions> occlusions = occlusions_of(served, owners_in(subject_, sequence(j)), pieces);
      executor_.for_each(subject_.draws.size(), [&](std::size_t d) {
        orders[j][d] = occlusion_order(subject_.draws[d], std::move(occlusions[d]), of_order);
      });
    });
    return orders;
  }

  std::uint64_t vertices_as_it_came() const {
    const Sequences order = as_it_came(subject_);
    std::uint64_t sum = 0;
    for (std::size_t d = 0; d < order.size(); ++d) {
      sum += shaded_vertices(subject_.draws[d], subject_.draws[d].atoms, order[d], options_.cache_size);
    }
    return std::max<std::uint64_t>(sum, 1);
  }

  static double visible_in(std::span<const WeightedLayers> looks) {
    double sum = 0;
    for (const auto& [layers, weight] : looks) {
      sum += static_cast<double>(weight) * static_cast<double>(layers->always.visible);
    }
    return sum;
  }

  /// How much of a look's surroundings an order serves: nothing, or 1 to 256.
  std::int64_t share_of(std::size_t order, std::size_t look) const {
    constexpr std::int64_t all = 256, least = 16;
    std::int64_t served = 0, sum = 0;
    for (const auto& [near, weight] : near_.of(look)) {
      sum += weight;
      served += serving_[near] == order ? weight : 0;
    }
    const std::int64_t share = served * all / sum;
    return share < least ? 0 : share;
  }

  /// Looks are much like their neighbours: of many, some spread evenly over them say as much.
  std::vector<WeightedLayers> some_served_by(std::size_t order, std::size_t most) const {
    std::vector<WeightedLayers> served;
    for (std::size_t look = 0; look < looks(); ++look) {
      const std::int64_t share = share_of(order, look);
      if (share > 0) served.push_back({&subject_.layers.views[look], weights_[look] * share});
    }
    if (served.size() <= most) return served;
    constexpr std::uint32_t golden = 2654435769u;  // 2^32 / golden ratio: multiples of it are spread evenly
    const auto limit = static_cast<std::uint32_t>((std::uint64_t{most} << 32) / served.size());
    std::uint32_t spread = 0;
    std::erase_if(served, [&](const WeightedLayers&) { return (spread += golden) >= limit; });
    return served;
  }

  /// Gives every look to the order that draws least there and around it.
  void serve(const std::vector<Sequences>& orders) {
    std::vector<std::vector<OverdrawCount>> counts(orders.size());
    executor_.for_each(orders.size(), [&](std::size_t j) { counts[j] = counts_of(subject_, orders[j], sequence(j)); });
    costs_.clear();
    for (const auto& of_order : counts) costs_.push_back(cost_of(of_order));
    counts_.resize(looks());
    for (std::size_t look = 0; look < looks(); ++look) {
      std::size_t best = 0;
      std::uint64_t least = ~std::uint64_t{0};
      for (std::size_t j = 0; j < counts.size(); ++j) {
        std::uint64_t cost = 0;
        for (const auto& [near, weight] : near_.of(look)) {
          cost += static_cast<std::uint64_t>(weight) * cost_of_look(near, counts[j][near]);
        }
        if (cost >= least) continue;
        least = cost;
        best = j;
      }
      serving_[look] = static_cast<std::uint8_t>(best);
      counts_[look] = counts[best][look];
    }
  }

  std::uint64_t cost_of_look(std::size_t look, const OverdrawCount& count) const {
    return static_cast<std::uint64_t>(weights_[look]) * (count.shaded - count.visible);
  }

  std::uint64_t cost_of(std::span<const OverdrawCount> counts) const {
    std::uint64_t cost = 0;
    for (std::size_t look = 0; look < counts.size(); ++look) cost += cost_of_look(look, counts[look]);
    return cost;
  }

  /// An order that serves nothing gets the look that is served worst.
  void give_work_to_idle_orders() {
    std::vector<std::size_t> served(k_, 0);
    for (const std::uint8_t order : serving_) ++served[order];
    for (std::size_t j = 0; j < k_; ++j) {
      if (served[j] > 0 || looks() == 0) continue;
      std::size_t worst = 0;
      for (std::size_t look = 1; look < looks(); ++look) {
        if (cost_of_look(look, counts_[look]) > cost_of_look(worst, counts_[worst])) worst = look;
      }
      if (served[serving_[worst]] < 2) continue;
      --served[serving_[worst]];
      ++served[j];
      serving_[worst] = static_cast<std::uint8_t>(j);
      counts_[worst].shaded = counts_[worst].visible;  // what it costs next is not known yet
    }
  }

  void put_best_first(KOrders& result) const {
    const auto best = static_cast<std::uint8_t>(std::ranges::min_element(costs_) - costs_.begin());
    std::swap(result.orders[0], result.orders[best]);
    if (!result.sequences.empty()) std::swap(result.sequences[0], result.sequences[best]);
    for (std::uint8_t& order : result.serving) {
      order = order == 0 ? best : order == best ? std::uint8_t{0} : order;
    }
  }

  const SubjectLayers& subject_;
  const KSequences* sequences_;
  std::vector<std::uint8_t> first_serving_;  // [look] none: nothing is known to begin with
  const KOrdersOptions& options_;
  const Executor& executor_;
  std::size_t k_;
  std::vector<std::int64_t> weights_;  // [look] of a pixel
  NearLooks near_;
  std::vector<std::uint8_t> serving_;
  std::vector<OverdrawCount> counts_;  // [look] in the order that serves it
  std::vector<std::uint64_t> costs_;   // [order] if it served all looks
};

}  // namespace

std::size_t most_looks(OcclusionQuality quality) {
  switch (quality) {
    case OcclusionQuality::fast: return 512;
    case OcclusionQuality::balanced: return 1024;
    case OcclusionQuality::high: break;
  }
  return 4096;
}

KOrders k_orders(const SubjectLayers& subject, const KOrdersOptions& options, const Executor& executor,
                 const KSequences* sequences) {
  return Alternation(subject, options, executor, sequences).run();
}

}  // namespace foredraw
