#include "frequency_candidates.h"

#include <algorithm>
#include <limits>

namespace foredraw::processors::merge_instances {

namespace {

std::uint32_t rounded_up(std::uint64_t entries, std::uint32_t multiple) {
  const std::uint64_t rounded = (entries + multiple - 1) / multiple * multiple;
  // The largest multiple below 2^32 where rounding up would leave it: such a mesh gets a second slot.
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(rounded, std::numeric_limits<std::uint32_t>::max() / multiple * multiple));
}

double total(std::span<const MeshSize> sizes, std::uint32_t frequency, const Prices& prices, double at_most) {
  double sum = 0;
  for (const MeshSize& size : sizes) {
    sum += cost_of(size, frequency, prices);
    if (sum > at_most) break;
  }
  return sum;
}

/// What the cost of a frequency can not be less than, without a look at each size: meshes that are smaller than a slot
/// pad the rest of it, and larger ones need their entries' worth of slots.
class LeastCost {
 public:
  LeastCost(std::span<const MeshSize> sizes, const Prices& prices) : sizes_(sizes), prices_(prices) {
    before_.push_back({});
    for (const MeshSize& size : sizes) {
      const auto placed = static_cast<double>(size.placed);
      before_.push_back(
          {before_.back().placed + placed, before_.back().entries + placed * static_cast<double>(size.indices)});
    }
  }

  double at(std::uint32_t frequency) const {
    const auto first_larger = std::ranges::upper_bound(sizes_, frequency, {}, &MeshSize::indices) - sizes_.begin();
    const Sums& small = before_[static_cast<std::size_t>(first_larger)];
    const double padded = small.placed * frequency - small.entries;
    const double slots = small.placed + (before_.back().entries - small.entries) / frequency;
    return (padded * prices_.padded + slots * prices_.slot) * (1 - 1e-9);  // less than any error of these sums
  }

 private:
  struct Sums {
    double placed = 0, entries = 0;
  };
  std::span<const MeshSize> sizes_;
  Prices prices_;
  std::vector<Sums> before_;
};

}  // namespace

std::vector<MeshSize> distinct_sizes(std::span<const MeshSize> meshes) {
  std::vector<MeshSize> sizes;
  for (const MeshSize& mesh : meshes) {
    if (mesh.indices > 0 && mesh.placed > 0) sizes.push_back(mesh);
  }
  std::ranges::sort(sizes, {}, &MeshSize::indices);
  std::size_t kept = 0;
  for (const MeshSize& size : sizes) {
    if (kept > 0 && sizes[kept - 1].indices == size.indices) {
      sizes[kept - 1].placed += size.placed;
    } else {
      sizes[kept++] = size;
    }
  }
  sizes.resize(kept);
  return sizes;
}

std::vector<std::uint32_t> frequency_candidates(std::span<const MeshSize> sizes, std::uint32_t multiple,
                                                std::uint32_t least, std::uint32_t most) {
  if (sizes.empty()) return {};
  most = std::min(most, rounded_up(sizes.back().indices, multiple));
  if (least > most) return {};
  // Many sizes find the same ones: marks where the range is small, else sorted at last.
  const std::size_t range = (most - least) / multiple + 2;
  std::vector<char> marks(range <= 4'000'000 ? range : 0);
  std::vector<std::uint32_t> candidates;
  for (const MeshSize& size : sizes) {
    const std::uint64_t n = size.indices;
    // From few slots to many; numbers of slots that come to the same frequency are stepped over, so that there are at
    // most about twice the square root of n / multiple.
    for (std::uint64_t slots = std::max<std::uint64_t>(1, n / most);;) {
      const std::uint32_t frequency = rounded_up((n + slots - 1) / slots, multiple);
      if (frequency < least) break;
      if (frequency <= most) {
        if (marks.empty()) {
          candidates.push_back(frequency);
        } else {
          marks[(frequency - least) / multiple] = 1;
        }
      }
      if (frequency <= multiple) break;
      slots = std::max(slots + 1, (n + frequency - multiple - 1) / (frequency - multiple));
    }
  }
  const std::uint64_t first = (std::uint64_t{least} + multiple - 1) / multiple * multiple;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0) candidates.push_back(static_cast<std::uint32_t>(first + i * multiple));
  }
  std::ranges::sort(candidates);
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

std::uint32_t best_frequency(std::span<const MeshSize> sizes, std::uint32_t multiple, const Prices& prices) {
  const LeastCost least_cost(sizes, prices);
  const std::uint32_t smallest = multiple;
  const std::uint32_t largest = rounded_up(sizes.back().indices, multiple);

  // A first answer from frequencies that grow by a quarter each, and from there how far away a better one can lie.
  double best = std::numeric_limits<double>::infinity();
  for (std::uint64_t f = smallest; f <= largest; f += std::max<std::uint64_t>(1, f / multiple / 4) * multiple) {
    best = std::min(best, total(sizes, static_cast<std::uint32_t>(f), prices, best));
  }
  best = std::min(best, total(sizes, largest, prices, best));
  double entries = 0, placed = 0;
  for (const MeshSize& size : sizes) {
    placed += static_cast<double>(size.placed);
    entries += static_cast<double>(size.placed) * static_cast<double>(size.indices);
  }
  // Below, the slots alone cost more; above, the padding of what is smaller does, more so the larger the frequency.
  const double enough = prices.slot * entries / best * (1 - 1e-9);
  std::uint32_t least = smallest;
  if (enough > smallest)
    least = std::min<std::uint32_t>(largest, static_cast<std::uint32_t>(enough) / multiple * multiple);
  std::uint32_t most = largest;
  if (prices.padded > 0 && placed * largest - entries > 0) {
    // placed * f - entries is what all of them would pad in a slot each, and never more than what they pad, as larger
    // ones count below nothing.
    const double too_many = (best * (1 + 1e-9) / prices.padded + entries) / placed + 1;
    if (too_many < largest) most = std::max(least, rounded_up(static_cast<std::uint64_t>(too_many), multiple));
  }

  std::uint32_t found = largest;
  double found_cost = std::numeric_limits<double>::infinity();
  for (const std::uint32_t f : frequency_candidates(sizes, multiple, least, most)) {
    if (least_cost.at(f) > std::min(best, found_cost)) continue;
    const double cost = total(sizes, f, prices, found_cost);
    if (cost < found_cost) {
      found_cost = cost;
      found = f;
    }
  }
  return found;
}

}  // namespace foredraw::processors::merge_instances
