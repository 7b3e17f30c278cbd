#pragma once
// How far two surfaces lie apart: the nearest point of one for points all over the other, both ways.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/analysis/sampled.h>
#include <foredraw/analysis/surface_samples.h>
#include <foredraw/base/parallel.h>

#include <cstdint>
#include <optional>

namespace foredraw {

struct SurfaceDistanceOptions {
  std::size_t samples = 4096;  ///< on each surface
  std::uint64_t seed = 0;
};

/// From one surface to the other.
struct OneWayDistance {
  double largest = 0;  ///< found: the true one is this or more
  Sampled mean;
  Sampled rms;
  Sampled p99;  ///< 99 of 100 points are no farther
};

/// Of points spread evenly by area, at least one. 0 of a surface that has no triangle; infinite to one that has none.
OneWayDistance one_way_distance(const Surface& of, const ClosestPoints& to, std::size_t samples, std::uint64_t seed,
                                const Executor& executor);

/// Both ways. Vertices that triangles use count towards the largest, too.
struct SurfaceDistance {
  OneWayDistance there, back;  ///< from a to b, from b to a
  double largest = 0;
  double rms = 0;        ///< root of the mean square over both surfaces, each weighing the same
  double rms_error = 0;  ///< one standard error of that
};

/// Nothing where one surface, and not the other, has no triangle of which anything is finite. The same at any number of
/// threads. After Cignoni, Rocchini, Scopigno 1998 (Metro) and Aspert, Santa-Cruz, Ebrahimi 2002.
std::optional<SurfaceDistance> surface_distance(const Surface& a, const Surface& b,
                                                const SurfaceDistanceOptions& options, const Executor& executor);

/// The nearest points for these ones; faster where each is near the one before it.
std::vector<Closest> nearest_points(std::span<const glm::dvec3> points, const ClosestPoints& to,
                                    const Executor& executor);

}  // namespace foredraw
