#include "occlusion_order.h"

#include "pieces.h"

#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace foredraw {

namespace {

struct Effort {
  std::uint32_t finest, coarsest;  // atoms, by the most triangles that they may have
  std::size_t plenty;              // atoms of a draw: with fewer, what hides what is blurred
  int sweeps, sweeps_of_joined;    // of the search, at most
  std::size_t joined;              // one of so many joints is made before the search goes on
};

Effort effort_of(OcclusionQuality quality, bool fine_atoms) {
  switch (quality) {
    case OcclusionQuality::fast: return {24, 48, 512, 1, 1, 2};
    case OcclusionQuality::balanced: return fine_atoms ? Effort{1, 24, 4096, 2, 1, 8} : Effort{12, 24, 512, 2, 2, 3};
    case OcclusionQuality::high: break;
  }
  return fine_atoms ? Effort{1, 8, 8192, 8, 2, 12} : Effort{8, 8, 512, 8, 8, 4};
}

std::vector<std::uint32_t> as_numbered(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

/// Those that were joined may move, and what they have to do with. `joined`: [old] = new piece.
void unsettle_joined(PieceOrder& search, std::span<const std::uint32_t> joined) {
  for (std::size_t piece = 1; piece < joined.size(); ++piece) {
    if (joined[piece] == joined[piece - 1]) search.unsettle(joined[piece]);
  }
}

std::vector<std::uint32_t> atoms_of(const Clusters& atoms, const Clusters& pieces,
                                    std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> result;
  result.reserve(atoms.count());
  for (const std::uint32_t piece : order) {
    const auto first = std::ranges::lower_bound(atoms.offsets, pieces.offsets[piece]);
    for (auto atom = first; *atom < pieces.offsets[piece + 1]; ++atom) {
      result.push_back(static_cast<std::uint32_t>(atom - atoms.offsets.begin()));
    }
  }
  return result;
}

}  // namespace

std::uint64_t shaded_vertices(const AtomicDraw& draw, const Clusters& ranges, std::span<const std::uint32_t> order,
                              std::uint32_t cache_size) {
  FifoCache cache(draw.vertex_count, cache_size);
  std::uint64_t sum = 0;
  for (const std::uint32_t range : order) {
    const std::size_t first = 3 * std::size_t{ranges.offsets[range]};
    sum += cache.misses(draw.indices.subspan(first, 3 * std::size_t{ranges.offsets[range + 1]} - first));
  }
  return sum;
}

AtomSize atom_size(const OcclusionOrderOptions& options, std::size_t triangles) {
  const Effort effort = effort_of(options.quality, options.fine_atoms);
  const auto most =
      static_cast<std::uint32_t>(std::clamp<std::size_t>(triangles / effort.plenty, effort.finest, effort.coarsest));
  return {std::max(1u, most / 3), most};
}

std::vector<std::uint32_t> occlusion_order(const AtomicDraw& draw, Occlusions occlusions,
                                           const OcclusionOrderOptions& options) {
  if (draw.atoms.count() < 2) return as_numbered(draw.atoms.count());
  const Effort effort = effort_of(options.quality, options.fine_atoms);
  std::vector<std::uint32_t> order = as_numbered(draw.atoms.count());
  const double budget =
      options.acmr_budget * static_cast<double>(shaded_vertices(draw, draw.atoms, order, options.cache_size));
  Pieces pieces{draw.atoms, misses_of_cuts(draw.indices, draw.vertex_count, options.cache_size, draw.atoms),
                PiecePlaces::as_numbered(draw.atoms.count())};
  std::vector<std::uint32_t> joined;
  for (;;) {
    PieceOrder search(occlusions, pieces.places);
    unsettle_joined(search, joined);
    search.improve(joined.empty() ? effort.sweeps : effort.sweeps_of_joined);
    order = search.order();
    if (options.acmr_budget == std::numeric_limits<double>::infinity()) break;
    const std::uint64_t shaded = shaded_vertices(draw, pieces.ranges, order, options.cache_size);
    std::vector<Joint> joints = joints_of(search, pieces.saved);
    double wanted = static_cast<double>(shaded) - budget;
    if (wanted <= 0) {  // what costs less than it saves is made all the same
      std::erase_if(joints, [&](const Joint& joint) { return joint.price > options.vertex_cost; });
      wanted = std::numeric_limits<double>::infinity();
    }
    if (joints.empty()) break;
    joined = pieces.join(joints, wanted, joints.size() / effort.joined + 1);
    occlusions = with_joined_pieces(occlusions, joined);
  }
  return atoms_of(draw.atoms, pieces.ranges, order);
}

}  // namespace foredraw
