#include "shells.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/c/checked_input.h>
#include <foredraw/c/functions.h>

#include <algorithm>

using namespace foredraw;

static_assert(FOREDRAW_SHELL_CLOSED == static_cast<int>(processors::second_depth::Kind::closed) &&
              FOREDRAW_SHELL_OPEN == static_cast<int>(processors::second_depth::Kind::open) &&
              FOREDRAW_SHELL_FLAT == static_cast<int>(processors::second_depth::Kind::flat) &&
              FOREDRAW_SHELL_INSIDE_OUT == static_cast<int>(processors::second_depth::Kind::inside_out) &&
              FOREDRAW_SHELL_TURNED == static_cast<int>(processors::second_depth::Kind::turned));

int foredraw_shell_kinds(uint8_t* kinds, const foredraw_triangles* triangles, const foredraw_positions* positions) {
  return c::with_triangles(triangles, kinds, [&](const c::CheckedTriangles& checked) -> int {
    const std::size_t vertices = checked.vertex_count();
    if (const int status = c::positions_status(positions, vertices)) return status;
    if (checked.triangle_count() == 0) return FOREDRAW_DONE;
    const auto places = c::elements_at<glm::vec3>(positions->first, positions->stride, vertices);
    const std::vector<processors::second_depth::Kind> found =
        processors::second_depth::kinds_of(places, welded(places), checked.indices());
    std::ranges::transform(found, kinds,
                           [](processors::second_depth::Kind kind) { return static_cast<std::uint8_t>(kind); });
    return FOREDRAW_DONE;
  });
}
