#include "forsyth.h"

#include <foredraw/c/checked_input.h>

using namespace foredraw;

int foredraw_forsyth(uint32_t* order, const foredraw_triangles* triangles, uint32_t cache_size) {
  return c::with_triangles(triangles, order, [&](const c::CheckedTriangles& checked) -> int {
    ForsythOptions options;
    if (const int status = c::take_option(cache_size, 3, 64, options.cache_size)) return status;
    forsyth({order, checked.triangle_count()}, checked.indices(), checked.vertex_count(), options,
            *std::pmr::new_delete_resource());
    return FOREDRAW_DONE;
  });
}
