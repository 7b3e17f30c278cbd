#include "overdraw_raster.h"

#include <foredraw/base/this_thread.h>
#include <foredraw/c/checked_input.h>
#include <foredraw/overdraw/overdraw_figures.h>
#include <foredraw/viewing/view_directions.h>

using namespace foredraw;

int foredraw_overdraw(foredraw_overdraw_figures* figures, const foredraw_triangles* triangles,
                      const foredraw_positions* positions, uint32_t view_count, uint32_t size, int shows_back_faces) {
  return c::with_triangles(triangles, figures, [&](const c::CheckedTriangles& checked) -> int {
    if (figures == nullptr) return FOREDRAW_NULL_POINTER;
    if (const int status = c::positions_status(positions, checked.vertex_count())) return status;
    int count = 100, pixels = 256;
    if (const int status = c::take_option(view_count, 1, 100'000, count)) return status;
    if (const int status = c::take_option(size, 16, 4096, pixels)) return status;
    if (shows_back_faces < 0 || shows_back_faces > 1) return FOREDRAW_OPTION_RANGE;
    if (checked.indices().size() >= std::size_t{1} << 31) return FOREDRAW_TOO_LARGE;

    std::vector<glm::vec3> places;
    if (checked.vertex_count() > 0) {
      places = c::elements_at<glm::vec3>(positions->first, positions->stride, checked.vertex_count());
    }
    Views views{{}, pixels};
    for (const glm::dvec3& direction : fibonacci_directions(static_cast<std::size_t>(count))) {
      views.views.push_back({direction});
    }
    const RasterPart part{places, checked.indices(), shows_back_faces == 0};
    const auto counts = overdraw_raster({&part, 1}, views, on_this_thread()).front();
    OverdrawCount sum, worst;
    std::vector<ViewTally> tallies(counts.size());
    for (std::size_t view = 0; view < counts.size(); ++view) {
      sum += counts[view];
      tallies[view].add(counts[view]);
      if (is_worse(counts[view], worst)) worst = counts[view];
    }
    const auto ratio_of = [](const OverdrawCount& of) {
      return of.visible == 0 ? 0 : static_cast<double>(of.shaded) / static_cast<double>(of.visible);
    };
    *figures = {sum.shaded,     sum.visible, sum.ties, ratio_of(sum), overdraw_ratio(tallies, views.views).error,
                ratio_of(worst)};
    return FOREDRAW_DONE;
  });
}
