#include "simplify.h"

#include <foredraw/collapses/collapse_limits.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

Simplified simplify(const JoinedMesh& mesh, const CollapseSequence& sequence, const Replay& run,
                    const SimplifyOptions& options, const Executor& executor, const std::atomic<bool>* cancel) {
  const double all = run.triangles.front();
  const bool has_count = options.ratio || options.triangles;
  const double wanted = std::max(std::ceil(options.ratio.value_or(0) * all), double(options.triangles.value_or(0)));
  const double goal = has_count ? wanted : options.error ? 0 : std::ceil(all / 2);
  const std::uint32_t triangles = static_cast<std::uint32_t>(std::min(goal, all));
  Simplified answer;
  answer.collapses = std::min(collapses_to(run, triangles), collapses_that_leave_draws(sequence, mesh));
  if (run.triangles[answer.collapses] > triangles) answer.end = Simplified::End::sequence;
  if (options.error) {
    const std::size_t most = answer.collapses;
    answer.collapses =
        collapses_within(sequence, mesh, DrawDistances(mesh), *options.error, 0, most, {.cancel = cancel}, executor);
    if (answer.collapses < most) answer.end = Simplified::End::error;
  }
  answer.triangles = run.triangles[answer.collapses];
  return answer;
}

}  // namespace foredraw
