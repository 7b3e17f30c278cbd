#pragma once
// The largest distance between surfaces, proved: not of samples, but of every point.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/base/parallel.h>

#include <atomic>
#include <cstdint>
#include <optional>

namespace foredraw {

struct FarthestOptions {
  double tolerance = 0.02;  ///< the bound exceeds what was found by at most this part of it; above 0
  /// For nearest points, each way, beside those for the vertices: where they do not suffice, the interval stays wider.
  /// Unless it is set, some 64 for each triangle, of which a few are usually needed.
  std::optional<std::uint64_t> most_questions = std::nullopt;
  const std::atomic<bool>* cancel = nullptr;  ///< once it is true the search ends, with the interval known by then
};

/// An interval that holds the true distance, in the unit of the positions.
struct Farthest {
  double found = 0;  ///< of the point `at`: the true one is this or more
  double bound = 0;  ///< the true one is this or less
  glm::dvec3 at{0};  ///< of the surface that is measured from
  std::uint64_t questions = 0;
  /// bound <= found * (1 + tolerance) + the precision that a float has at the greatest coordinate.
  bool is_within_tolerance = true;
};

/// How far the farthest point of one surface is from the other (the one-sided Hausdorff distance). 0 where `of` has no
/// triangle; nothing where `to` alone has none. The same at any number of threads.
///
/// By branch and bound. The distance from a triangle is convex, so over a flat piece of the surface it is largest at a
/// corner of the piece: the largest of a piece is at most that of its corners from any one triangle. A piece for which
/// no triangle proves enough is cut along the outline of the triangle that is nearest to its middle, so the pieces come
/// to be those of one surface laid over the other, and their number hardly depends on the tolerance.
/// Bounds from single triangles: Tang, Lee, Kim, "Interactive Hausdorff Distance Computation for General Polygonal
/// Models", SIGGRAPH 2009. The cuts are ours.
std::optional<Farthest> farthest_distance(const Surface& of, const ClosestPoints& to, const FarthestOptions& options,
                                          const Executor& executor);

/// A surface, and where it is nearest.
struct SearchedSurface {
  Surface surface;
  const ClosestPoints& points;  ///< of that surface
};

/// Both ways: the farther one (the Hausdorff distance). 0 where neither surface has a triangle.
std::optional<Farthest> hausdorff_distance(const SearchedSurface& a, const SearchedSurface& b,
                                           const FarthestOptions& options, const Executor& executor);

/// Whether no point of `of` is farther than `distance`, a float's precision at the greatest coordinate aside. Ends as
/// soon as either is known; nothing where the questions do not suffice, or `to` alone has no triangle.
std::optional<bool> is_within(const Surface& of, const ClosestPoints& to, double distance,
                              const FarthestOptions& options, const Executor& executor);

}  // namespace foredraw
