#include <foredraw/overdraw/layers.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace foredraw {

namespace {

/// How many fragments of the lists pass. Without a branch on what is compared: orders have no pattern.
template <class Owner, class Length>
std::uint64_t count_passing(const Owner* list, std::uint32_t lists, Length length, const std::uint32_t* inverse) {
  std::uint64_t passing = lists;  // nothing is nearer than the first of each
  for (std::uint32_t i = 0; i < lists; ++i, list += length) {
    std::uint32_t earliest = inverse[list[0]];
    for (std::uint32_t layer = 1; layer < length; ++layer) {
      const std::uint32_t turn = inverse[list[layer]];
      passing += turn <= earliest ? 1 : 0;
      earliest = std::min(earliest, turn);
    }
  }
  return passing;
}

/// Lengths that are common are known to the compiler, so that their loops have no end to guess.
template <class Owner, std::uint32_t length = 2>
std::uint64_t count_passing(const Owner* list, const LayerBatch& batch, const std::uint32_t* inverse) {
  constexpr std::uint32_t longest = 8;
  if (batch.length == length) {
    return count_passing(list, batch.lists, std::integral_constant<std::uint32_t, length>(), inverse);
  }
  if constexpr (length < longest) return count_passing<Owner, length + 1>(list, batch, inverse);
  return count_passing(list, batch.lists, batch.length, inverse);
}

/// Of equally near owners the first one drawn alone passes, and only where nothing nearer was drawn; the others that
/// come before all that is nearer are ties. Without a branch here too.
template <class Owner>
OverdrawCount count_with_ties(std::span<const Owner> list, std::span<const std::uint32_t> inverse) {
  OverdrawCount count;
  std::uint32_t earliest = ~std::uint32_t{0};
  std::uint32_t nearer = earliest;  // earliest without those as near as the owner
  std::uint32_t has_passed = 0;     // one as near as the owner
  for (const Owner owner : list) {
    const bool is_tied = owner >= tie_bit<Owner>;
    nearer = is_tied ? nearer : earliest;
    has_passed = is_tied ? has_passed : 0;
    const std::uint32_t turn = inverse[owner & static_cast<Owner>(~tie_bit<Owner>)];
    const std::uint32_t is_unhindered = turn <= nearer ? 1 : 0;
    count.shaded += is_unhindered & ~has_passed;
    count.ties += is_unhindered & has_passed;
    has_passed |= is_unhindered;
    earliest = std::min(earliest, turn);
  }
  return count;
}

OverdrawCount count_in_turns(const ViewLayers& view, std::span<const std::uint32_t> inverse) {
  OverdrawCount sum = view.always;
  for_each_batch(view, [&]<class Owner>(const LayerBatch& batch, const Owner* list) {
    if (!batch.has_ties) {
      sum.shaded += batch.weight * count_passing(list, batch, inverse.data());
      return;
    }
    for (std::uint32_t i = 0; i < batch.lists; ++i, list += batch.length) {
      const OverdrawCount count = count_with_ties(std::span(list, batch.length), inverse);
      sum.shaded += batch.weight * count.shaded;
      sum.ties += batch.weight * count.ties;
    }
  });
  return sum;
}

}  // namespace

std::vector<std::uint32_t> inverse_of(std::span<const std::uint32_t> order, std::size_t owners) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  if (order.size() != owners) {
    throw std::invalid_argument("count_overdraw: the order has " + std::to_string(order.size()) +
                                " entries, the layers were made of " + std::to_string(owners) +
                                "; judge orders of these alone");
  }
  std::vector<std::uint32_t> inverse(owners, none);
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
    if (order[rank] >= owners || inverse[order[rank]] != none) {
      throw std::invalid_argument(
          "count_overdraw: order[" + std::to_string(rank) + "] = " + std::to_string(order[rank]) +
          " is out of range or comes twice; an order names " + "each of 0 to " + std::to_string(owners) + " - 1 once");
    }
    inverse[order[rank]] = rank;
  }
  return inverse;
}

std::size_t bytes_of(const ViewLayers& view) {
  return sizeof(view) + view.batches.size() * sizeof(LayerBatch) +
         std::visit([](const auto& owners) { return owners.size() * sizeof(owners[0]); }, view.owners);
}

std::size_t Layers::bytes() const {
  std::size_t sum = 0;
  for (const ViewLayers& view : views) sum += bytes_of(view);
  return sum;
}

std::vector<OverdrawCount> count_overdraw_by_view(const Layers& layers, std::span<const std::uint32_t> order) {
  const std::vector<std::uint32_t> inverse = inverse_of(order, layers.owners);
  std::vector<OverdrawCount> counts;
  for (const ViewLayers& view : layers.views) counts.push_back(count_in_turns(view, inverse));
  return counts;
}

OverdrawCount count_overdraw(const Layers& layers, std::span<const std::uint32_t> order) {
  OverdrawCount sum;
  for (const OverdrawCount& count : count_overdraw_by_view(layers, order)) sum += count;
  return sum;
}

ShadedBounds shaded_bounds(const Layers& layers) {
  ShadedBounds sum;
  for (const ViewLayers& view : layers.views) {
    sum.least += view.always.shaded;
    sum.most += view.always.shaded;
    for_each_batch(view, [&]<class Owner>(const LayerBatch& batch, const Owner* owners) {
      const std::size_t length = std::size_t{batch.lists} * batch.length;
      const auto ties = std::count_if(owners, owners + length, [](Owner owner) { return owner >= tie_bit<Owner>; });
      sum.least += std::uint64_t{batch.weight} * batch.lists;
      sum.most += batch.weight * (length - static_cast<std::size_t>(ties));
    });
  }
  return sum;
}

}  // namespace foredraw
