#include "surface_error.h"

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/base/random.h>

#include <algorithm>

namespace foredraw {

namespace {

OneWayError one_way_error(const Surface& of, const ClosestPoints& to, const SurfaceErrorOptions& options,
                          std::uint64_t seed, const Executor& executor, const std::atomic<bool>* cancel) {
  const OneWayDistance sampled = one_way_distance(of, to, static_cast<std::size_t>(options.samples), seed, executor);
  const Farthest farthest = *farthest_distance(of, to, {.tolerance = options.tolerance, .cancel = cancel}, executor);
  OneWayError error{sampled.rms, sampled.mean, sampled.p99, std::max(sampled.largest, farthest.found)};
  error.largest = std::max(error.found, farthest.bound);
  return error;
}

/// What is not finite equals nothing.
bool is_same(const Surface& a, const Surface& b) {
  return std::ranges::equal(a.indices, b.indices) && std::ranges::equal(a.positions, b.positions);
}

}  // namespace

double SurfaceError::found() const { return std::max(to_original.found, from_original.found); }

double SurfaceError::largest() const { return std::max(to_original.largest, from_original.largest); }

Sampled SurfaceError::p99() const {
  return to_original.p99.value < from_original.p99.value ? from_original.p99 : to_original.p99;
}

Sampled SurfaceError::mean() const { return mean_of_both(to_original.mean, from_original.mean); }

Sampled SurfaceError::rms() const { return rms_of_both(to_original.rms, from_original.rms); }

std::optional<SurfaceError> surface_error(const SearchedSurface& changed, const SearchedSurface& original,
                                          const SurfaceErrorOptions& options, std::uint64_t seed,
                                          const Executor& executor, const std::atomic<bool>* cancel) {
  if (changed.points.empty() != original.points.empty()) return std::nullopt;
  if (changed.points.empty() || is_same(changed.surface, original.surface)) return SurfaceError{};
  return SurfaceError{
      one_way_error(changed.surface, original.points, options, derive_seed(seed, 0, 0), executor, cancel),
      one_way_error(original.surface, changed.points, options, derive_seed(seed, 1, 0), executor, cancel)};
}

std::optional<SurfaceError> surface_error(const Surface& changed, const Surface& original,
                                          const SurfaceErrorOptions& options, std::uint64_t seed,
                                          const Executor& executor, const std::atomic<bool>* cancel) {
  if (is_same(changed, original)) return SurfaceError{};
  const ClosestPoints of_changed(changed), of_original(original);
  return surface_error({changed, of_changed}, {original, of_original}, options, seed, executor, cancel);
}

}  // namespace foredraw
