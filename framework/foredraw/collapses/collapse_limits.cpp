#include <foredraw/collapses/collapse_limits.h>

#include <algorithm>
#include <functional>

namespace foredraw {

namespace {

/// The last number of `least` to `most` that is good, given that those up to it are; `least` is taken to be.
std::size_t last_good(std::size_t least, std::size_t most, const auto& is_good) {
  if (most <= least || is_good(most)) return std::max(least, most);
  std::size_t good = least, bad = most;
  while (good + 1 < bad) {
    const std::size_t middle = good + (bad - good) / 2;
    (is_good(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

double distance_of_pixels(double pixels, double away) {
  constexpr double height = 1080, tangent = 0.57735026918962576;  // of half the field of view
  return pixels * 2 * tangent * away / height;
}

std::size_t collapses_to(const Replay& run, std::uint32_t triangles) {
  const auto reached = std::ranges::lower_bound(run.triangles, triangles, std::greater<>());
  return std::min<std::size_t>(reached - run.triangles.begin(), run.triangles.size() - 1);
}

std::size_t collapses_that_leave_draws(const CollapseSequence& sequence, const JoinedMesh& mesh) {
  const auto draws_left = [&](std::size_t collapses) {
    const Collapsed after = collapsed(sequence, collapses, mesh);
    std::size_t left = 0;
    for (std::size_t d = 0; d < mesh.stream_of.size(); ++d) left += !indices_of(after, mesh, d).empty();
    return left;
  };
  const std::size_t all = draws_left(0);
  return last_good(0, sequence.collapses.size(), [&](std::size_t collapses) { return draws_left(collapses) == all; });
}

std::size_t collapses_within(const CollapseSequence& sequence, const JoinedMesh& mesh, const DrawDistances& distances,
                             double distance, std::size_t least, std::size_t most, const FarthestOptions& search,
                             const Executor& executor) {
  return last_good(least, most, [&](std::size_t collapses) {
    return distances.are_within(collapsed(sequence, collapses, mesh), distance, search, executor);
  });
}

}  // namespace foredraw
