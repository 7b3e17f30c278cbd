#pragma once
// How far a surface lies from another one that it stands for.

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/analysis/sampled.h>

#include <atomic>
#include <cstdint>
#include <optional>

namespace foredraw {

struct SurfaceErrorOptions {
  int samples = 10000;      ///< points on each surface, from 1 on; the figures with a standard error are of these
  double tolerance = 0.02;  ///< `largest` exceeds `found` by at most this part of it
};

/// Distances from one surface to the other, in the unit of the positions.
struct OneWayError {
  Sampled rms, mean, p99;  ///< of points spread evenly by area; p99: 99 of 100 are no farther
  double found = 0;        ///< a point is so far away,
  double largest = 0;      ///< and none is farther: proved
};

struct SurfaceError {
  OneWayError to_original, from_original;

  /// The larger one of the two ways.
  double found() const;
  double largest() const;
  Sampled p99() const;
  /// Both surfaces weigh the same.
  Sampled mean() const;
  Sampled rms() const;
};

/// Nothing where one of them, and not the other, has no triangle with finite positions. The same at any number of
/// threads. Once `cancel` is true, the largest distances are no longer proved: they may be infinite.
std::optional<SurfaceError> surface_error(const Surface& changed, const Surface& original,
                                          const SurfaceErrorOptions& options, std::uint64_t seed,
                                          const Executor& executor, const std::atomic<bool>* cancel = nullptr);

/// The same of surfaces whose nearest points are at hand.
std::optional<SurfaceError> surface_error(const SearchedSurface& changed, const SearchedSurface& original,
                                          const SurfaceErrorOptions& options, std::uint64_t seed,
                                          const Executor& executor, const std::atomic<bool>* cancel = nullptr);

struct Plugin;
Plugin surface_error_plugin();

}  // namespace foredraw
