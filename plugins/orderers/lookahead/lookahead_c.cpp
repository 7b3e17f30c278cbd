#include "lookahead.h"

#include <foredraw/c/checked_input.h>

#include <array>

using namespace foredraw;

namespace {

/// By the numbers of FOREDRAW_LOOKAHEAD_FAST and so on; 0 is the default.
constexpr std::array qualities = {LookaheadQuality::balanced, LookaheadQuality::fast, LookaheadQuality::balanced,
                                  LookaheadQuality::high};
constexpr std::array targets = {LookaheadTarget::robust, LookaheadTarget::robust, LookaheadTarget::fifo,
                                LookaheadTarget::nvidia, LookaheadTarget::amd,    LookaheadTarget::intel};

/// A negative number is a large one.
template <class Choices>
bool is_one_of(const Choices& choices, int number) {
  return static_cast<unsigned>(number) < choices.size();
}

}  // namespace

int foredraw_lookahead(uint32_t* order, const foredraw_triangles* triangles, int quality, int target,
                       uint32_t cache_size) {
  return c::with_triangles(triangles, order, [&](const c::CheckedTriangles& checked) -> int {
    if (!is_one_of(qualities, quality) || !is_one_of(targets, target)) return FOREDRAW_OPTION_RANGE;
    LookaheadOptions options{.quality = qualities[quality], .target = targets[target]};
    if (const int status = c::take_option(cache_size, 3, 256, options.cache_size)) return status;
    if (!lookahead_takes(checked.indices().size())) return FOREDRAW_TOO_LARGE;
    lookahead({order, checked.triangle_count()}, checked.indices(), checked.vertex_count(), options,
              *std::pmr::new_delete_resource());
    return FOREDRAW_DONE;
  });
}
