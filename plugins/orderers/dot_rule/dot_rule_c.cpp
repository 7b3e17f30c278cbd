#include "dot_rule.h"

#include <foredraw/c/checked_input.h>

#include <algorithm>

using namespace foredraw;

int foredraw_dot_rule(uint32_t* sequence, const foredraw_triangles* triangles, const foredraw_positions* positions,
                      const uint32_t* offsets, uint32_t cluster_count) {
  return c::with_triangles(triangles, sequence, [&](const c::CheckedTriangles& checked) -> int {
    if (cluster_count == 0) return checked.triangle_count() == 0 ? FOREDRAW_DONE : FOREDRAW_NO_CLUSTERS;
    if (sequence == nullptr || positions == nullptr || positions->first == nullptr || offsets == nullptr) {
      return FOREDRAW_NULL_POINTER;
    }
    if (const int status = c::offsets_status({offsets, std::size_t{cluster_count} + 1}); status != FOREDRAW_DONE) {
      return status;
    }
    if (offsets[cluster_count] != checked.triangle_count()) return FOREDRAW_NO_CLUSTERS;
    const std::size_t stride = positions->stride == 0 ? sizeof(glm::vec3) : positions->stride;
    const Strided<glm::vec3> places(positions->first, checked.vertex_count(), stride);
    std::ranges::copy(dot_rule(places, checked.indices(), {{offsets, offsets + cluster_count + 1}}), sequence);
    return FOREDRAW_DONE;
  });
}
