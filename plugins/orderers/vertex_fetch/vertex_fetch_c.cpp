#include "vertex_fetch.h"

#include <foredraw/c/checked_input.h>

#include <algorithm>

using namespace foredraw;

int foredraw_vertex_fetch(uint32_t* order, uint32_t* used_count, const foredraw_triangles* triangles) {
  return c::with_triangles(triangles, order, [&](const c::CheckedTriangles& checked) -> int {
    if (order == nullptr && checked.vertex_count() > 0) return FOREDRAW_NULL_POINTER;
    const std::span<const std::uint32_t> indices = checked.indices();
    const std::vector<std::uint32_t> found = vertex_fetch({&indices, 1}, checked.vertex_count());
    std::vector<bool> is_used(checked.vertex_count());
    for (const std::uint32_t index : indices) is_used[index] = true;
    std::ranges::copy(found, order);
    if (used_count != nullptr) *used_count = static_cast<std::uint32_t>(std::ranges::count(is_used, true));
    return FOREDRAW_DONE;
  });
}
