#include "linear_clusters.h"

#include <foredraw/c/checked_input.h>

#include <algorithm>
#include <limits>

using namespace foredraw;

int foredraw_linear_clusters(uint32_t* offsets, uint32_t* cluster_count, const foredraw_triangles* triangles,
                             uint32_t cache_size, double growth) {
  return c::with_triangles(triangles, offsets, [&](const c::CheckedTriangles& checked) -> int {
    if (offsets == nullptr || cluster_count == nullptr) return FOREDRAW_NULL_POINTER;
    int size = 16;
    if (const int status = c::take_option(cache_size, 3, std::numeric_limits<int>::max(), size)) return status;
    LinearClustersOptions options;
    if (growth != 0) options.growth = growth;
    if (!(options.growth >= 1)) return FOREDRAW_OPTION_RANGE;
    const Clusters clusters = linear_clusters(checked.indices(), checked.vertex_count(), size, options);
    *offsets = 0;
    std::ranges::copy(clusters.offsets, offsets);
    *cluster_count = static_cast<std::uint32_t>(clusters.count());
    return FOREDRAW_DONE;
  });
}
