#include "surface_error.h"

#include <foredraw/base/this_thread.h>
#include <foredraw/c/checked_input.h>

using namespace foredraw;

int foredraw_surface_error(foredraw_surface_error_figures* figures, const foredraw_triangles* changed,
                           const foredraw_positions* changed_positions, const foredraw_triangles* original,
                           const foredraw_positions* original_positions, uint32_t samples, uint64_t seed) {
  return c::guarded([&]() -> int {
    if (figures == nullptr) return FOREDRAW_NULL_POINTER;
    SurfaceErrorOptions options;
    constexpr std::uint32_t most = 100'000'000;
    if (const int status = c::take_option(samples, 1, most, options.samples)) return status;
    const c::CheckedTriangles triangles[] = {c::CheckedTriangles(changed), c::CheckedTriangles(original)};
    const foredraw_positions* const given[] = {changed_positions, original_positions};
    std::vector<glm::vec3> places[2];
    for (std::size_t i = 0; i < 2; ++i) {
      if (triangles[i].status() != FOREDRAW_DONE) return triangles[i].status();
      const std::size_t vertices = triangles[i].vertex_count();
      if (const int status = c::positions_status(given[i], vertices)) return status;
      if (triangles[i].triangle_count() > std::size_t{1} << 31) return FOREDRAW_TOO_LARGE;
      if (vertices > 0) places[i] = c::elements_at<glm::vec3>(given[i]->first, given[i]->stride, vertices);
    }
    const auto error = surface_error({places[0], triangles[0].indices()}, {places[1], triangles[1].indices()}, options,
                                     seed, on_this_thread());
    if (!error) return FOREDRAW_NO_TRANSFORM;
    *figures = {error->largest(),    error->found(),      error->rms().value, error->rms().error,
                error->mean().value, error->mean().error, error->p99().value, error->p99().error};
    return FOREDRAW_DONE;
  });
}
