#pragma once
// Who hides whom: fragment layers as a search for orders asks them.

#include <foredraw/overdraw/subject_layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Which pieces of a draw hide which others, summed over views. A fragment that is drawn though it does not stay costs
/// its weight. All that no order changes is left out.
struct Occlusions {
  std::uint32_t pieces = 0;

  /// Two pieces in a pixel. Row p is [first_pair[p], first_pair[p + 1]) of `pairs`.
  struct Pair {
    std::uint32_t other;
    std::int64_t net;  ///< what it costs to draw p after `other`, less what it costs to draw it before
  };
  std::vector<std::uint32_t> first_pair;
  std::vector<Pair> pairs;

  /// More pieces in a pixel, front to back: list l is [first_layer[l], first_layer[l + 1]) of `layers`. A piece comes
  /// several times where its farther fragments are drawn before its nearer ones.
  std::vector<std::uint32_t> first_layer;
  std::vector<std::uint32_t> layers;
  std::vector<std::int64_t> weights;  ///< [list]
  /// The lists that piece p is in: [first_list[p], first_list[p + 1]) of `lists`.
  std::vector<std::uint32_t> first_list;
  std::vector<std::uint32_t> lists;
};

/// A view's layers, and how much one of its pixels counts.
struct WeightedLayers {
  const ViewLayers* layers = nullptr;
  std::int64_t weight = 1;
};

/// Of each draw of a subject. `pieces`: how many each has; `owners`: what the layers' owners are. What lies behind
/// another part's nearer fragment that is drawn before it never passes, and what later parts hide is theirs: so a pixel
/// falls apart into one list for each part, and draws are ordered one by one. Of fragments that are equally near the
/// first in the list stands for all.
std::vector<Occlusions> occlusions_of(std::span<const WeightedLayers> views, std::span<const LayerOwner> owners,
                                      std::span<const std::uint32_t> pieces);

/// Of larger pieces: each one or several of the old ones, one behind the other, drawn in their sequence. `joined`:
/// [old] = new, ascending, each new one there.
Occlusions with_joined_pieces(const Occlusions& occlusions, std::span<const std::uint32_t> joined);

}  // namespace foredraw
