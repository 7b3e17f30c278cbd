#pragma once
// Pieces of an order that grow: two that came in one behind the other are joined where that costs least.

#include "piece_order.h"

#include <foredraw/scene/clusters.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Two pieces that came in one behind the other made one, at the place of either.
struct Joint {
  double price = 0;  ///< overdraw for each vertex that need not be shaded again
  std::uint32_t second = 0;
  bool at_first = false;
};

struct Pieces {
  Clusters ranges;                   ///< of triangles
  std::vector<std::uint32_t> saved;  ///< [piece] vertices that it need not shade behind the one before it
  PiecePlaces places;

  /// Makes joints, each piece in one at most, until they save `wanted` vertices or there are `most`. [old] = new piece.
  std::vector<std::uint32_t> join(std::span<const Joint> joints, double wanted, std::size_t most);
};

/// All that save something, the cheapest first.
std::vector<Joint> joints_of(PieceOrder& order, std::span<const std::uint32_t> saved);

}  // namespace foredraw
