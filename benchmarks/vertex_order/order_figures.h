#pragma once
// What an index buffer is worth: the figures of the contest.

#include "bench_meshes.h"

#include <optional>

namespace foredraw::bench {

/// The caches that ACMR is measured with.
std::vector<std::string> cache_names();

struct OrderFigures {
  std::vector<double> acmr;   ///< misses a triangle, one for each of cache_names()
  double atvr = 0;            ///< misses a vertex that is drawn, FIFO of 16
  std::optional<double> ovr;  ///< shaded over visible fragments, 42 orthographic views, back faces culled
};

/// Meshes above so many triangles are not drawn: each order would take seconds.
constexpr std::size_t most_drawn_triangles = 300'000;

/// `orders` holds an index buffer for each mesh of the set. Of all meshes together: sums over sums.
OrderFigures figures_of(const MeshSet& set, const std::vector<std::vector<std::uint32_t>>& orders);

}  // namespace foredraw::bench
