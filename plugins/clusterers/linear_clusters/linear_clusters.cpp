#include "linear_clusters.h"

#include <foredraw/analysis/vertex_cache.h>

#include <vector>

namespace foredraw {

namespace {

std::vector<std::uint32_t> hard_boundaries(std::span<const std::uint32_t> indices, FifoCache& cache) {
  const auto triangles = static_cast<std::uint32_t>(indices.size() / 3);
  std::vector<std::uint32_t> offsets{0};
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (cache.misses(indices.subspan(3 * std::size_t{t}, 3)) == 3 && t > 0) offsets.push_back(t);
  }
  if (triangles > 0) offsets.push_back(triangles);
  return offsets;
}

/// The misses per triangle of a hard patch that is drawn alone.
double own_acmr(std::span<const std::uint32_t> indices, std::uint32_t begin, std::uint32_t end, FifoCache& cache) {
  cache.flush();
  const std::uint32_t triangles = end - begin;
  return static_cast<double>(cache.misses(indices.subspan(3 * std::size_t{begin}, 3 * std::size_t{triangles}))) /
         triangles;
}

}  // namespace

Clusters linear_clusters(std::span<const std::uint32_t> indices, std::size_t vertex_count, int cache_size,
                         const LinearClustersOptions& options) {
  FifoCache cache(vertex_count, static_cast<std::uint32_t>(cache_size));
  const std::vector<std::uint32_t> hard = hard_boundaries(indices, cache);

  Clusters clusters{{0}};
  for (std::size_t h = 0; h + 1 < hard.size(); ++h) {
    const std::uint32_t begin = hard[h];
    const std::uint32_t end = hard[h + 1];
    const double lambda = options.lambda ? *options.lambda : options.growth * own_acmr(indices, begin, end, cache);

    cache.flush();
    std::uint64_t misses = 0;
    std::uint32_t start = begin;
    for (std::uint32_t t = begin; t < end; ++t) {
      misses += cache.misses(indices.subspan(3 * std::size_t{t}, 3));
      if (static_cast<double>(misses) > lambda * (t + 1 - start)) continue;
      clusters.offsets.push_back(t + 1);
      start = t + 1;
      misses = 0;
      cache.flush();
    }
    // Whatever follows the last patch that was closed did not get down to lambda: it stays with that patch.
    if (clusters.offsets.back() > begin) clusters.offsets.pop_back();
    clusters.offsets.push_back(end);
  }
  return clusters;
}

}  // namespace foredraw
