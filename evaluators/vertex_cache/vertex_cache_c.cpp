#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/c/checked_input.h>

#include <algorithm>

using namespace foredraw;

int foredraw_vertex_cache(foredraw_vertex_cache_figures* figures, const foredraw_triangles* triangles,
                          uint32_t cache_size) {
  return c::with_triangles(triangles, figures, [&](const c::CheckedTriangles& checked) -> int {
    if (figures == nullptr) return FOREDRAW_NULL_POINTER;
    int size = 16;
    if (const int status = c::take_option(cache_size, 1, 65535, size)) return status;
    if (checked.indices().size() >= std::size_t{1} << 31) return FOREDRAW_TOO_LARGE;  // what the cache counts
    FifoCache cache(checked.vertex_count(), static_cast<std::uint32_t>(size));
    std::vector<bool> is_used(checked.vertex_count());
    std::uint64_t misses = 0;
    for (const std::uint32_t index : checked.indices()) {
      misses += cache.misses(index);
      is_used[index] = true;
    }
    const auto used = static_cast<std::uint64_t>(std::ranges::count(is_used, true));
    const auto per = [&](std::uint64_t count) {
      return count == 0 ? 0 : static_cast<double>(misses) / static_cast<double>(count);
    };
    *figures = {misses, used, per(checked.triangle_count()), per(used)};
    return FOREDRAW_DONE;
  });
}
