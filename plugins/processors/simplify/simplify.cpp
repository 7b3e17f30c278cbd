#include "simplify.h"

#include <foredraw/analysis/farthest_distance.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// The fewest collapses after which no more triangles than that are left; all, where there are always more.
std::size_t collapses_to(const Replay& run, std::uint32_t triangles) {
  const auto reached = std::ranges::lower_bound(run.triangles, triangles, std::greater<>());
  return std::min<std::size_t>(reached - run.triangles.begin(), run.triangles.size() - 1);
}

}  // namespace

Simplified simplify(const JoinedMesh& mesh, const CollapseSequence& sequence, const Replay& run,
                    const SimplifyOptions& options, const Executor& executor, const std::atomic<bool>* cancel) {
  const double all = run.triangles.front();
  const bool has_count = options.ratio || options.triangles;
  const double wanted = std::max(std::ceil(options.ratio.value_or(0) * all), double(options.triangles.value_or(0)));
  const double goal = has_count ? wanted : options.error ? 0 : std::ceil(all / 2);
  const std::uint32_t triangles = static_cast<std::uint32_t>(std::min(goal, all));
  Simplified answer;
  answer.collapses = collapses_to(run, triangles);
  if (run.triangles[answer.collapses] > triangles) answer.end = Simplified::End::sequence;
  if (options.error) {
    const Surface full{mesh.positions, mesh.indices};
    const ClosestPoints to_full(full);
    const auto is_near = [&](std::size_t collapses) {
      const Collapsed after = collapsed(sequence, collapses, mesh.positions, mesh.indices);
      const Surface coarse{after.places, after.indices};
      const FarthestOptions search{.cancel = cancel};
      return is_within(coarse, to_full, *options.error, search, executor).value_or(false) &&
             is_within(full, ClosestPoints(coarse), *options.error, search, executor).value_or(false);
    };
    std::size_t near = 0, far = answer.collapses + 1;
    if (is_near(answer.collapses)) near = answer.collapses;
    while (near + 1 < far && near != answer.collapses) {
      const std::size_t middle = near + (far - near) / 2;
      (is_near(middle) ? near : far) = middle;
    }
    if (near < answer.collapses) answer.end = Simplified::End::error;
    answer.collapses = near;
  }
  answer.triangles = run.triangles[answer.collapses];
  return answer;
}

}  // namespace foredraw
