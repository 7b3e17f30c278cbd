#include "frequency.h"

#include "class_search.h"
#include "frequency_candidates.h"
#include "padding_limit.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace foredraw::processors::merge_instances {

namespace {

void check(std::span<const MeshSize> meshes, const FrequencyOptions& options) {
  if (options.multiple == 0 || options.multiple % 3 != 0) {
    throw std::invalid_argument("multiple must be a multiple of 3, so that no triangle is cut");
  }
  if (options.classes < 1 || options.classes > 4) throw std::invalid_argument("frequencies must be 1 to 4");
  const auto is_price = [](double price) { return price >= 0 && price <= 1e30; };  // false for what is no number
  if (!is_price(options.slot_bytes) || !is_price(options.padded_cost) || !is_price(options.slot_byte_cost) ||
      !is_price(options.class_cost)) {
    throw std::invalid_argument("the costs of padding, slots and draws must be numbers from 0 to 1e30");
  }
  for (const MeshSize& mesh : meshes) {
    if (mesh.indices > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument("a mesh has 2^32 index entries or more; split it");
    }
  }
}

/// Each mesh at the frequency where it costs least, of equals the largest: it needs the fewest slots.
FrequencyChoice choice_at(std::span<const MeshSize> meshes, std::vector<std::uint32_t> frequencies,
                          const Prices& prices) {
  FrequencyChoice choice;
  choice.frequencies = std::move(frequencies);
  for (const MeshSize& mesh : meshes) {
    std::size_t cheapest = choice.frequencies.size() - 1;
    for (std::size_t k = cheapest; k-- > 0;) {
      if (cost_of(mesh, choice.frequencies[k], prices) < cost_of(mesh, choice.frequencies[cheapest], prices))
        cheapest = k;
    }
    choice.mesh_class.push_back(static_cast<std::uint8_t>(cheapest));
    const std::uint64_t slots = slots_of(mesh.indices, choice.frequencies[cheapest]);
    choice.indices += mesh.placed * mesh.indices;
    choice.padded += mesh.placed * (slots * choice.frequencies[cheapest] - mesh.indices);
    choice.slots += mesh.placed * slots;
  }
  return choice;
}

/// Each mesh at the frequency that its size was given.
FrequencyChoice choice_as(std::span<const MeshSize> meshes, std::span<const MeshSize> sizes,
                          std::span<const std::uint32_t> frequencies, std::span<const std::uint8_t> size_class) {
  FrequencyChoice choice;
  choice.frequencies.assign(frequencies.begin(), frequencies.end());
  for (const MeshSize& mesh : meshes) {
    const auto size = std::ranges::lower_bound(sizes, mesh.indices, {}, &MeshSize::indices) - sizes.begin();
    const bool is_placed = size < std::ssize(sizes) && sizes[static_cast<std::size_t>(size)].indices == mesh.indices;
    const std::uint8_t at = is_placed ? size_class[static_cast<std::size_t>(size)] : std::uint8_t{0};
    choice.mesh_class.push_back(at);
    const std::uint64_t slots = slots_of(mesh.indices, frequencies[at]);
    choice.indices += mesh.placed * mesh.indices;
    choice.padded += mesh.placed * (slots * frequencies[at] - mesh.indices);
    choice.slots += mesh.placed * slots;
  }
  return choice;
}

FrequencyChoice nothing_for(std::span<const MeshSize> meshes) {
  FrequencyChoice choice;
  choice.mesh_class.assign(meshes.size(), 0);
  return choice;
}

/// One more class is taken where it pays for its draws.
FrequencyChoice cheapest(std::span<const MeshSize> meshes, std::span<const MeshSize> sizes, const Prices& prices,
                         const FrequencyOptions& options) {
  FrequencyChoice best = choice_at(meshes, {best_frequency(sizes, options.multiple, prices)}, prices);
  const auto cost = [&](const FrequencyChoice& choice) {
    return static_cast<double>(choice.padded) * prices.padded + static_cast<double>(choice.slots) * prices.slot +
           static_cast<double>(choice.frequencies.size() - 1) * options.class_cost;
  };
  best.cost = best.bound = cost(best);
  for (std::uint32_t classes = 2; classes <= options.classes; ++classes) {
    const double extra = options.class_cost * (classes - 1);
    if (extra >= best.cost) break;
    const ClassSearch found = search_classes(sizes, options.multiple, classes, prices, options.most_steps);
    FrequencyChoice choice = choice_at(meshes, found.frequencies, prices);
    choice.cost = cost(choice);
    const double bound = std::min(best.bound, found.bound < found.cost ? found.bound + extra : choice.cost);
    if (choice.cost < best.cost) best = std::move(choice);
    best.bound = bound;
  }
  best.proven = best.bound >= best.cost;
  return best;
}

std::optional<FrequencyChoice> fewest_slots_of_one(std::span<const MeshSize> meshes, std::span<const MeshSize> sizes,
                                                   double most_padding, const FrequencyOptions& options) {
  const std::vector<std::uint32_t> candidates =
      frequency_candidates(sizes, options.multiple, options.multiple, std::numeric_limits<std::uint32_t>::max());
  double entries = 0;
  for (const MeshSize& size : sizes) entries += static_cast<double>(size.placed) * static_cast<double>(size.indices);
  // Each candidate needs fewer slots than the one before it, so the largest that keeps the limit is the best.
  for (std::size_t c = candidates.size(); c-- > 0;) {
    double padded = 0;
    for (std::size_t i = 0; i < sizes.size() && padded * (1 - most_padding) <= most_padding * entries * (1 + 1e-9);
         ++i) {
      padded += cost_of(sizes[i], candidates[c], {1, 0});
    }
    if (padded * (1 - most_padding) > most_padding * entries * (1 + 1e-9)) continue;
    FrequencyChoice choice = choice_at(meshes, {candidates[c]}, {});
    if (choice.padding() > most_padding) continue;
    choice.cost = choice.bound = static_cast<double>(choice.slots);
    return choice;
  }
  return std::nullopt;
}

}  // namespace

FrequencyChoice best_frequencies(std::span<const MeshSize> meshes, const FrequencyOptions& options) {
  check(meshes, options);
  const std::vector<MeshSize> sizes = distinct_sizes(meshes);
  if (sizes.empty()) return nothing_for(meshes);
  return cheapest(meshes, sizes, {options.padded_cost, options.slot_bytes * options.slot_byte_cost}, options);
}

std::optional<FrequencyChoice> fewest_slots(std::span<const MeshSize> meshes, double most_padding,
                                            const FrequencyOptions& options) {
  check(meshes, options);
  if (!(most_padding >= 0 && most_padding <= 1)) throw std::invalid_argument("most-padding must be from 0 to 1");
  const std::vector<MeshSize> sizes = distinct_sizes(meshes);
  if (sizes.empty()) return nothing_for(meshes);
  std::optional<FrequencyChoice> best = fewest_slots_of_one(meshes, sizes, most_padding, options);
  if (!best || options.classes == 1) return best;

  // With a price of 1 for a slot, a padded entry's price is looked for at which the padding just keeps below the limit.
  // What is cheapest under a price bounds everything: no choice has fewer slots than slots + price * padding there,
  // less price * the most padding. The price that bounds best leaves few choices of frequencies to look at one by one.
  FrequencyOptions free_classes = options;
  free_classes.class_cost = 0;
  const double share = std::min(most_padding, 0.999999);
  const auto most_padded = static_cast<std::uint64_t>(share / (1 - share) * static_cast<double>(best->indices));
  double cheap = 0, dear = 1, price = 1, bound = 0;
  const auto fits = [&](double at) {
    FrequencyChoice choice = cheapest(meshes, sizes, {at, 1}, free_classes);
    const double least = choice.bound - at * static_cast<double>(most_padded);
    if (least > bound) {
      bound = least;
      price = at;
    }
    const bool kept = choice.padded <= most_padded;
    if (kept && choice.slots < best->slots) best = std::move(choice);
    return kept;
  };
  for (int i = 0; i < 40 && !fits(dear); ++i) {
    cheap = dear;
    dear *= 4;
  }
  for (int i = 0; i < 10; ++i) {
    const double middle = (cheap + dear) / 2;
    (fits(middle) ? dear : cheap) = middle;
  }

  const auto below = [&] { return static_cast<double>(best->slots) - 0.5 + price * static_cast<double>(most_padded); };
  bool proven = true;
  for (std::uint32_t classes = 2; classes <= options.classes; ++classes) {
    const bool all =
        visit_choices(sizes, options.multiple, classes, {price, 1}, options.most_steps, below(),
                      [&](std::span<const std::uint32_t> frequencies) {
                        if (const auto found = limited_slots(sizes, frequencies, most_padded, best->slots)) {
                          best = choice_as(meshes, sizes, frequencies, found->size_class);
                          proven = proven && found->proven;
                        }
                        return below();
                      });
    proven = proven && all && classes == 2;
  }
  best->cost = static_cast<double>(best->slots);
  best->bound = proven ? best->cost : std::min(bound, best->cost);
  best->proven = best->bound >= best->cost;
  return best;
}

}  // namespace foredraw::processors::merge_instances
