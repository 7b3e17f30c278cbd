#include "tipsify.h"

#include <foredraw/c/checked_input.h>

#include <limits>

using namespace foredraw;

int foredraw_tipsify(uint32_t* order, const foredraw_triangles* triangles, uint32_t cache_size) {
  return c::with_triangles(triangles, order, [&](const c::CheckedTriangles& checked) -> int {
    TipsifyOptions options;
    constexpr int most = std::numeric_limits<int>::max();
    if (const int status = c::take_option(cache_size, 3, most, options.cache_size)) return status;
    if (!tipsify_takes(checked.indices().size(), checked.vertex_count(), options)) return FOREDRAW_TOO_LARGE;
    tipsify({order, checked.triangle_count()}, checked.indices(), checked.vertex_count(), options,
            *std::pmr::new_delete_resource());
    return FOREDRAW_DONE;
  });
}
