#include "animated_kmeans.h"

#include <foredraw/base/random.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace foredraw {

namespace {

using Order = std::vector<std::vector<std::uint32_t>>;  // [draw][rank] = patch

/// Looks by the buffers that serve them.
struct Clustering {
  std::vector<Order> orders;
  std::vector<std::uint8_t> serving;  // [look]
  std::vector<OverdrawCount> counts;  // [look]
  std::vector<double> alone;          // [buffer] its cost if it served all looks
  double cost = std::numeric_limits<double>::infinity();
};

class KMeans {
 public:
  KMeans(const SubjectLayers& subject, const PatchDistances& distances, const AnimatedKMeansOptions& options,
         const Executor& executor)
      : subject_(subject),
        patch_distances_(distances),
        options_(options),
        executor_(executor),
        looks_(subject.layers.views.size()),
        k_(std::min(static_cast<std::size_t>(options.k), looks_)) {}

  Clustering run() const {
    Clustering best;
    for (int start = 0; start <= options_.restarts; ++start) {
      std::vector<Order> orders = bootstrapped(start);
      double least = std::numeric_limits<double>::infinity();
      std::vector<std::uint8_t> before;
      for (int round = 0; round < options_.rounds; ++round) {
        const Clustering now = assigned(std::move(orders));
        if (now.cost < best.cost) best = now;
        if (now.serving == before || now.cost >= least) break;
        least = now.cost;
        before = now.serving;
        orders = computed(with_none_empty(now));
      }
    }
    return best;
  }

 private:
  /// Bootstrapping: k random looks, each with the patches front to back.
  std::vector<Order> bootstrapped(int start) const {
    Random random(derive_seed(options_.seed, static_cast<std::uint64_t>(start), 0));
    std::vector<std::size_t> looks(looks_);
    std::iota(looks.begin(), looks.end(), std::size_t{0});
    std::vector<Order> orders;
    for (std::size_t j = 0; j < k_; ++j) {
      std::swap(looks[j], looks[j + random.below(looks_ - j)]);
      std::vector<IntegratedDistance> distances;
      for (std::size_t patch = 0; patch < subject_.owners.size(); ++patch) {
        distances.push_back({patch_distances_.distance(looks[j], patch), 1});
      }
      orders.push_back(sorted(distances));
    }
    return orders;
  }

  /// Step 1, look assignment: to the buffer that draws the look with least overdraw.
  Clustering assigned(std::vector<Order> orders) const {
    std::vector<std::vector<OverdrawCount>> counts(orders.size());
    executor_.for_each(orders.size(), [&](std::size_t j) { counts[j] = counts_of(subject_, orders[j]); });
    Clustering result;
    for (const auto& of_buffer : counts) result.alone.push_back(cost_of(of_buffer));
    for (std::size_t look = 0; look < looks_; ++look) {
      std::size_t best = 0;
      for (std::size_t j = 1; j < counts.size(); ++j) {
        if (counts[j][look].shaded < counts[best][look].shaded) best = j;
      }
      result.serving.push_back(static_cast<std::uint8_t>(best));
      result.counts.push_back(counts[best][look]);
    }
    result.cost = cost_of(result.counts);
    result.orders = std::move(orders);
    return result;
  }

  /// What is covered is the same in every order, so that the less is shaded the lower is the ratio.
  double cost_of(const std::vector<OverdrawCount>& counts) const {
    const ViewTally tally = tally_of(subject_, counts);
    return options_.metric == OverdrawMetric::ratio ? tally.shaded : tally.ratios;
  }

  /// Step 2, index buffer computation: patches by the distance integrated over the looks that see them.
  std::vector<Order> computed(std::span<const std::uint8_t> serving) const {
    std::vector<Order> orders(k_);
    executor_.for_each(k_, [&](std::size_t j) {
      std::vector<IntegratedDistance> distances(subject_.owners.size());
      for (std::size_t look = 0; look < looks_; ++look) {
        if (serving[look] == j) patch_distances_.integrate(look, subject_.weights[look], distances);
      }
      orders[j] = sorted(distances);
    });
    return orders;
  }

  /// Buffers that serve nothing get the looks that are served worst.
  std::vector<std::uint8_t> with_none_empty(const Clustering& clustering) const {
    std::vector<std::uint8_t> serving = clustering.serving;
    std::vector<std::size_t> served(k_, 0);
    for (const std::uint8_t j : serving) ++served[j];
    std::vector<OverdrawCount> counts = clustering.counts;
    const auto overdrawn = [&](std::size_t look) {
      return subject_.weights[look] * static_cast<double>(counts[look].shaded - counts[look].visible);
    };
    for (std::size_t j = 0; j < k_; ++j) {
      if (served[j] > 0) continue;
      std::size_t worst = looks_;
      for (std::size_t look = 0; look < looks_; ++look) {
        if (served[serving[look]] > 1 && (worst == looks_ || overdrawn(look) > overdrawn(worst))) worst = look;
      }
      --served[serving[worst]];
      ++served[j];
      serving[worst] = static_cast<std::uint8_t>(j);
      counts[worst].shaded = counts[worst].visible;  // what it is in the new buffer, nobody knows yet
    }
    return serving;
  }

  /// Each draw's patches front to back, those last that no look sees. A draw that is seen twice has one distance.
  Order sorted(std::span<const IntegratedDistance> of_owners) const {
    std::vector<std::vector<IntegratedDistance>> sums;
    for (const AtomicDraw& draw : subject_.draws) sums.emplace_back(draw.atoms.count());
    for (std::size_t i = 0; i < of_owners.size(); ++i) {
      IntegratedDistance& sum = sums[subject_.owners[i].draw][subject_.owners[i].piece];
      sum.distance += of_owners[i].distance;
      sum.looks += of_owners[i].looks;
    }
    Order order;
    for (const auto& patches : sums) {
      std::vector<double> means;
      for (const auto& [distance, looks] : patches) {
        means.push_back(looks > 0 ? distance / looks : std::numeric_limits<double>::infinity());
      }
      std::vector<std::uint32_t>& sequence = order.emplace_back(patches.size());
      std::iota(sequence.begin(), sequence.end(), 0u);
      std::ranges::stable_sort(sequence, {}, [&](std::uint32_t patch) { return means[patch]; });
    }
    return order;
  }

  const SubjectLayers& subject_;
  const PatchDistances& patch_distances_;
  const AnimatedKMeansOptions& options_;
  const Executor& executor_;
  std::size_t looks_;
  std::size_t k_;
};

/// The buffers that serve looks, the one first that would do best alone.
IndexBuffers of_use(Clustering clustering) {
  std::vector<bool> is_used(clustering.orders.size(), false);
  for (const std::uint8_t j : clustering.serving) is_used[j] = true;
  std::vector<std::uint8_t> used;
  for (std::size_t j = 0; j < is_used.size(); ++j) {
    if (is_used[j]) used.push_back(static_cast<std::uint8_t>(j));
  }
  std::ranges::stable_sort(used, {}, [&](std::uint8_t j) { return clustering.alone[j]; });
  IndexBuffers buffers;
  std::vector<std::uint8_t> number(clustering.orders.size());
  for (const std::uint8_t j : used) {
    number[j] = static_cast<std::uint8_t>(buffers.orders.size());
    buffers.orders.push_back(std::move(clustering.orders[j]));
  }
  for (const std::uint8_t j : clustering.serving) buffers.serving.push_back(number[j]);
  buffers.counts = std::move(clustering.counts);
  return buffers;
}

}  // namespace

IndexBuffers animated_kmeans(const SubjectLayers& subject, const PatchDistances& distances,
                             const AnimatedKMeansOptions& options, const Executor& executor) {
  if (subject.layers.views.empty()) return {{as_it_came(subject)}, {}, {}};
  return of_use(KMeans(subject, distances, options, executor).run());
}

}  // namespace foredraw
