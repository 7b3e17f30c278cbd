#include "occlusion_order.h"

#include "piece_order.h"

#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace foredraw {

namespace {

struct Effort {
  std::uint32_t finest, coarsest;  // atoms, by the most triangles that they may have
  int sweeps;                      // of the search, at most
  std::size_t joined;              // one of so many joints is made before the search goes on
};

Effort effort_of(OcclusionQuality quality) {
  switch (quality) {
    case OcclusionQuality::fast: return {24, 48, 1, 2};
    case OcclusionQuality::balanced: return {12, 24, 2, 3};
    case OcclusionQuality::high: break;
  }
  return {8, 8, 8, 4};
}

std::vector<std::uint32_t> as_numbered(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

/// Two pieces that came in one behind the other made one, at the place of either.
struct Joint {
  double price;  // overdraw for each vertex that need not be shaded again
  std::uint32_t second;
  bool at_first;
};

/// All that save something, the cheapest first.
std::vector<Joint> joints_of(PieceOrder& order, std::span<const std::uint32_t> saved) {
  std::vector<Joint> joints;
  std::int64_t moving_first = order.cost_of_joining(0).before_next;
  for (std::uint32_t second = 1; second < saved.size(); ++second) {
    const auto [moving_second, before_next] = order.cost_of_joining(second);
    const std::int64_t cost = std::min(moving_first, moving_second);
    if (saved[second] > 0) {
      joints.push_back({static_cast<double>(cost) / saved[second], second, moving_second <= moving_first});
    }
    moving_first = before_next;
  }
  std::ranges::sort(joints, {}, [](const Joint& joint) { return std::pair(joint.price, joint.second); });
  return joints;
}

/// Pieces that joining makes larger.
struct Pieces {
  Clusters ranges;                   // of triangles
  std::vector<std::uint32_t> saved;  // [piece] misses that it is spared behind the one before it
  std::vector<double> ranks;         // [piece] in the order

  /// Makes joints, each piece in one at most, until they save `wanted` misses or there are `most`. [old] = new piece.
  std::vector<std::uint32_t> join(std::span<const Joint> joints, double wanted, std::size_t most) {
    std::vector<bool> is_taken(ranks.size(), false), is_joined(ranks.size(), false);
    double saving = 0;
    for (const auto& [price, second, at_first] : joints) {
      if (saving >= wanted || most == 0) break;
      if (is_taken[second - 1] || is_taken[second]) continue;
      is_taken[second - 1] = is_taken[second] = is_joined[second] = true;
      if (!at_first) ranks[second - 1] = ranks[second];
      saving += saved[second];
      --most;
    }
    std::vector<std::uint32_t> joined;
    std::uint32_t count = 0;
    for (std::uint32_t piece = 0; piece < ranks.size(); ++piece) {
      if (!is_joined[piece]) {
        ranges.offsets[count] = ranges.offsets[piece];
        ranks[count] = ranks[piece];
        saved[count++] = saved[piece];
      }
      joined.push_back(count - 1);
    }
    ranges.offsets[count] = ranges.offsets.back();
    ranges.offsets.resize(count + 1);
    ranks.resize(count);
    saved.resize(count);
    return joined;
  }
};

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

AtomSize atom_size(OcclusionQuality quality, std::size_t triangles) {
  constexpr std::size_t plenty = 512;  // atoms of a draw: with fewer, what hides what is blurred
  const Effort effort = effort_of(quality);
  const auto most =
      static_cast<std::uint32_t>(std::clamp<std::size_t>(triangles / plenty, effort.finest, effort.coarsest));
  return {most / 3, most};
}

std::vector<std::uint32_t> occlusion_order(const AtomicDraw& draw, Occlusions occlusions,
                                           const OcclusionOrderOptions& options) {
  if (draw.atoms.count() < 2) return as_numbered(draw.atoms.count());
  const Effort effort = effort_of(options.quality);
  std::vector<std::uint32_t> order = as_numbered(draw.atoms.count());
  const double budget =
      options.acmr_budget * static_cast<double>(shaded_vertices(draw, draw.atoms, order, options.cache_size));
  Pieces pieces{draw.atoms, misses_of_cuts(draw.indices, draw.vertex_count, options.cache_size, draw.atoms),
                std::vector<double>(order.begin(), order.end())};
  for (;;) {
    PieceOrder search(occlusions, std::move(pieces.ranks));
    search.improve(effort.sweeps);
    order = search.order();
    const std::uint64_t shaded = shaded_vertices(draw, pieces.ranges, order, options.cache_size);
    std::vector<Joint> joints = joints_of(search, pieces.saved);
    double wanted = static_cast<double>(shaded) - budget;
    if (wanted <= 0) {  // what costs less than it saves is made all the same
      std::erase_if(joints, [&](const Joint& joint) { return joint.price > options.vertex_cost; });
      wanted = std::numeric_limits<double>::infinity();
    }
    if (joints.empty()) break;
    pieces.ranks = search.ranks();
    occlusions = with_joined_pieces(occlusions, pieces.join(joints, wanted, joints.size() / effort.joined + 1));
  }
  return atoms_of(draw.atoms, pieces.ranges, order);
}

}  // namespace foredraw
