#include "hidden.h"

#include "camera_views.h"
#include "seen_search.h"

#include <foredraw/base/random.h>

#include <numeric>

namespace foredraw {

HiddenTriangles hidden_triangles(std::span<const OpaqueOrNot> draws, const HiddenOptions& options,
                                 const Executor& executor) {
  using namespace hidden;
  Sight sight;
  for (const OpaqueOrNot& draw : draws) {
    sight.parts.push_back({draw.positions, draw.indices, !draw.is_double_sided});
    sight.hides.push_back(draw.is_opaque);
  }
  const Surface surface(sight.parts);
  sight.triangles.resize(surface.component().size());
  std::iota(sight.triangles.begin(), sight.triangles.end(), 0u);
  const BetweenSteps go_on = [] {};
  SeenSearch search(surface, not_finite(sight.parts), options, go_on, executor);
  search.look(sight, deciding_views(sight.cameras, options), static_cast<std::size_t>(options.rays),
              derive_seed(options.seed, 3, 0));
  HiddenTriangles result;
  for (int round = 0; round < most_checks && search.hides_any(); ++round) {
    result.last_check = search.check(sight, checking_views(sight.cameras, options, round), 0);
    if (result.last_check.asked == 0) break;
  }
  const Flags flags = search.hidden();
  auto at = flags.begin();
  for (const OpaqueOrNot& draw : draws) {
    const auto end = at + static_cast<std::ptrdiff_t>(draw.indices.size() / 3);
    result.is_hidden.emplace_back(at, end);
    at = end;
  }
  return result;
}

}  // namespace foredraw
