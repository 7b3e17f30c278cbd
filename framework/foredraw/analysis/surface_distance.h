#pragma once
// How far two surfaces lie apart: the nearest point of one for points all over the other, both ways.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/analysis/surface_samples.h>
#include <foredraw/base/parallel.h>

#include <cstdint>
#include <optional>

namespace foredraw {

struct SurfaceDistanceOptions {
  std::size_t samples = 4096;  ///< on each surface
  std::uint64_t seed = 0;
};

/// A figure of samples, and one standard error of it.
struct Sampled {
  double value = 0;
  double error = 0;
};

/// From points of one surface to the other. Points are spread evenly by area; vertices that triangles use count towards
/// the largest alone.
struct OneWayDistance {
  double largest = 0;  ///< found: the true one is this or more
  Sampled mean;
  Sampled rms;  ///< root of the mean square
  Sampled p99;  ///< 99 of 100 points are no farther
};

/// Both ways.
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

/// The nearest points of `to` for these points, the samples of a surface say. Faster where each is near the one before.
std::vector<Closest> nearest_points(std::span<const glm::dvec3> points, const ClosestPoints& to,
                                    const Executor& executor);

/// Of sampled distances; `largest` is theirs alone.
OneWayDistance summed_up(std::vector<double> distances);

/// Each way weighs the same.
Sampled rms_of_both(const Sampled& there, const Sampled& back);

}  // namespace foredraw
