#include "hidden.h"

#include "camera_views.h"
#include "seen_search.h"

#include <foredraw/base/random.h>

#include <numeric>

namespace foredraw {

HiddenTriangles hidden_triangles(std::span<const OpaqueOrNot> draws, const HiddenOptions& options,
                                 const Executor& executor) {
  using namespace processors::hidden;
  Sight sight;
  for (const OpaqueOrNot& draw : draws) {
    sight.parts.push_back({draw.positions, draw.indices, !draw.is_double_sided});
    sight.hides.push_back(draw.is_opaque);
  }
  const Connected surface(sight.parts);
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
  Flags proved = search.proved();
  const Flags flags = search.hidden();
  for (std::size_t t = 0; t < flags.size(); ++t) proved[t] &= flags[t];
  std::size_t begin = 0;
  for (const OpaqueOrNot& draw : draws) {
    const std::size_t end = begin + draw.indices.size() / 3;
    const auto of_draw = [&](const Flags& all) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(begin),
                         all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    result.is_hidden.push_back(of_draw(flags));
    result.is_proved.push_back(of_draw(proved));
    begin = end;
  }
  return result;
}

}  // namespace foredraw
