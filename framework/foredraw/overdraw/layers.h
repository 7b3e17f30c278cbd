#pragma once
// What lies behind what, laid out to be asked often: equal lists are one with a weight, lists of equal length and
// weight lie together, and a list costs two or four bytes for each of its layers.

#include <foredraw/overdraw/overdraw_count.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace foredraw {

/// Lists one behind the other, all of the same length and weight.
struct LayerBatch {
  std::uint32_t length = 0;  ///< layers of a list
  std::uint32_t weight = 0;  ///< pixels that a list stands for
  std::uint32_t lists = 0;
  bool has_ties = false;
};

/// The pixels of one view, as lists of owners front to back.
struct ViewLayers {
  OverdrawCount always;             ///< shaded, ties: of what the lists leave out, in every order; visible: of all
  std::vector<LayerBatch> batches;  ///< in the sequence of the owners
  /// The highest bit of an owner says that it is as near as the one before it in its list.
  std::variant<std::vector<std::uint16_t>, std::vector<std::uint32_t>> owners;
};

/// The layers of a subject. Who owns them, triangles or clusters, the derived types say: FragmentLayers, ClusterLayers.
/// A cluster comes several times in a list where its farther fragments are drawn before its nearer ones.
struct Layers {
  std::size_t owners = 0;  ///< at most 2^31
  std::vector<ViewLayers> views;

  std::size_t bytes() const;
};

std::size_t bytes_of(const ViewLayers& view);

template <class Owner>
inline constexpr Owner tie_bit = static_cast<Owner>(Owner{1} << (8 * sizeof(Owner) - 1));

/// Calls visit(batch, first owner) for every batch.
template <class Visit>
void for_each_batch(const ViewLayers& view, Visit visit) {
  const auto visit_all = [&](const auto& owners) {
    const auto* list = owners.data();
    for (const LayerBatch& batch : view.batches) {
      visit(batch, list);
      list += std::size_t{batch.lists} * batch.length;
    }
  };
  std::visit(visit_all, view.owners);
}

/// What drawing the owners in this order counts, of all views: order[rank] = owner. The same as drawing them counts,
/// at any order. std::invalid_argument where the order is no permutation. O(owners + what the layers hold).
OverdrawCount count_overdraw(const Layers& layers, std::span<const std::uint32_t> order);

/// The same, [view].
std::vector<OverdrawCount> count_overdraw_by_view(const Layers& layers, std::span<const std::uint32_t> order);

/// The inverse of an order, order[rank] = owner: [owner] = rank. std::invalid_argument where it is no permutation of so
/// many.
std::vector<std::uint32_t> inverse_of(std::span<const std::uint32_t> order, std::size_t owners);

/// No order shades less or more. Every pixel reaches its least and its most, but seldom all of them in one order.
struct ShadedBounds {
  std::uint64_t least = 0;
  std::uint64_t most = 0;
};
ShadedBounds shaded_bounds(const Layers& layers);

}  // namespace foredraw
