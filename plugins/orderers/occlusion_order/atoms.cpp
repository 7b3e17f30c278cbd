#include "atoms.h"

#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>
#include <deque>

namespace foredraw {

namespace {

/// [t]: how many vertices a cut before triangle t parts from a use of theirs.
std::vector<std::uint32_t> parted_vertices(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                           std::uint32_t cache_size) {
  struct Stay {
    std::uint32_t first = 0, last = 0;  // triangles that use the vertex while it is in the cache
  };
  std::vector<Stay> stays(vertex_count);
  std::vector<std::uint32_t> change(indices.size() / 3 + 2, 0);  // from one triangle to the next, modulo 2^32
  const auto end = [&](const Stay& stay) {
    ++change[stay.first + 1];
    --change[stay.last + 1];
  };
  FifoCache cache(vertex_count, cache_size);
  for (std::uint32_t i = 0; i < indices.size(); ++i) {
    Stay& stay = stays[indices[i]];
    if (cache.misses(indices[i])) {
      end(stay);
      stay.first = i / 3;
    }
    stay.last = i / 3;
  }
  for (const Stay& stay : stays) end(stay);
  std::uint32_t sum = 0;
  for (std::uint32_t& parted : change) parted = sum += parted;
  return change;
}

/// Appends the ends of the atoms of [first, end).
void cut_piece(std::span<const std::uint32_t> parted, std::uint32_t first, std::uint32_t end, const AtomSize& size,
               std::vector<std::uint32_t>& ends) {
  const std::uint32_t n = end - first;
  const std::size_t begin_at = ends.size();
  if (n < 2 * size.least) {
    ends.push_back(end);
    return;
  }
  constexpr std::uint64_t none = ~std::uint64_t{0};
  std::vector<std::uint64_t> least(n + 1, none);
  std::vector<std::uint32_t> begin(n + 1, 0);
  std::deque<std::uint32_t> candidates;
  least[0] = 0;
  for (std::uint32_t t = size.least; t <= n; ++t) {
    const std::uint32_t entering = t - size.least;
    if (least[entering] != none) {
      while (!candidates.empty() && least[candidates.back()] > least[entering]) candidates.pop_back();
      candidates.push_back(entering);
    }
    while (!candidates.empty() && candidates.front() + size.most < t) candidates.pop_front();
    if (candidates.empty()) continue;
    begin[t] = candidates.front();
    least[t] = least[begin[t]] + (t < n ? parted[first + t] : 0);
  }
  for (std::uint32_t t = n; t > 0; t = begin[t]) ends.push_back(first + t);
  std::reverse(ends.begin() + static_cast<std::ptrdiff_t>(begin_at), ends.end());
}

}  // namespace

Clusters cut_atoms(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::uint32_t cache_size,
                   const AtomSize& size) {
  const auto triangles = static_cast<std::uint32_t>(indices.size() / 3);
  if (triangles == 0) return {{0}};
  const std::vector<std::uint32_t> parted = parted_vertices(indices, vertex_count, cache_size);
  Clusters atoms{{0}};
  for (std::uint32_t first = 0, t = 1; t <= triangles; ++t) {
    if (t < triangles && parted[t] > 0) continue;
    cut_piece(parted, first, t, size, atoms.offsets);
    first = t;
  }
  return atoms;
}

std::vector<std::uint32_t> misses_of_cuts(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                          std::uint32_t cache_size, const Clusters& atoms) {
  FifoCache whole(vertex_count, cache_size);
  FifoCache alone(vertex_count, cache_size);
  std::vector<std::uint32_t> misses;
  for (std::size_t i = 0; i < atoms.count(); ++i) {
    const std::size_t first = 3 * std::size_t{atoms.offsets[i]};
    const auto atom = indices.subspan(first, 3 * std::size_t{atoms.offsets[i + 1]} - first);
    alone.flush();
    const std::uint32_t cold = alone.misses(atom);
    const std::uint32_t warm = whole.misses(atom);
    misses.push_back(i == 0 ? 0 : cold - std::min(cold, warm));
  }
  return misses;
}

}  // namespace foredraw
