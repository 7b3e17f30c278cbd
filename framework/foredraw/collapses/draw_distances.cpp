#include <foredraw/collapses/draw_distances.h>

#include <algorithm>

namespace foredraw {

DrawDistances::DrawDistances(const JoinedMesh& mesh) : mesh_(mesh) {
  for (std::size_t d = 0; d < mesh.stream_of.size(); ++d) {
    points_.push_back(std::make_unique<const ClosestPoints>(full(d)));
  }
}

Surface DrawDistances::full(std::size_t draw) const {
  const std::uint32_t first = mesh_.first_index[draw], end = mesh_.first_index[draw + 1];
  return {mesh_.positions, std::span(mesh_.indices).subspan(first, end - first)};
}

std::optional<Farthest> DrawDistances::farthest(const Collapsed& after, const FarthestOptions& options,
                                                const Executor& executor) const {
  Farthest most;
  for (std::size_t d = 0; d < points_.size(); ++d) {
    const Surface coarse{after.places, indices_of(after, mesh_, d)};
    const auto one = hausdorff_distance({full(d), *points_[d]}, {coarse, ClosestPoints(coarse)}, options, executor);
    if (!one) return std::nullopt;
    if (one->bound > most.bound) most = *one;
  }
  return most;
}

bool DrawDistances::are_within(const Collapsed& after, double distance, const FarthestOptions& options,
                               const Executor& executor) const {
  for (std::size_t d = 0; d < points_.size(); ++d) {
    const Surface coarse{after.places, indices_of(after, mesh_, d)};
    if (!is_within(coarse, *points_[d], distance, options, executor).value_or(false)) return false;
    if (!is_within(full(d), ClosestPoints(coarse), distance, options, executor).value_or(false)) return false;
  }
  return true;
}

}  // namespace foredraw
