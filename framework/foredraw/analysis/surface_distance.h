#pragma once
// How far two surfaces lie apart: the nearest point of one for points all over the other, both ways.

#include <foredraw/base/parallel.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace foredraw {

/// Triangles, three indices each, all below the number of positions. What is not finite is left out.
struct Surface {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;
};

/// Answers how far a point is from the nearest point of a surface, of which it keeps a copy. O(n log n) to make, some
/// 120 bytes a triangle.
class ClosestPoints {
 public:
  explicit ClosestPoints(const Surface& surface);
  ~ClosestPoints();

  /// The distance, in the unit of the positions; infinite where the surface has no triangle. For a point that is
  /// finite.
  double distance(glm::dvec3 point) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

struct SurfaceDistanceOptions {
  std::size_t samples = 4096;  ///< on each surface
  std::uint64_t seed = 0;
};

/// Of points spread evenly by area over both surfaces; vertices that triangles use count towards the largest alone.
struct SurfaceDistance {
  double largest = 0;    ///< found, either way: the true one is this or more
  double rms = 0;        ///< root of the mean square over both surfaces, each weighing the same
  double rms_error = 0;  ///< one standard error of that
};

/// Nothing where one surface, and not the other, has no triangle of which anything is finite. The same at any number of
/// threads. After Cignoni, Rocchini, Scopigno 1998 (Metro) and Aspert, Santa-Cruz, Ebrahimi 2002.
std::optional<SurfaceDistance> surface_distance(const Surface& a, const Surface& b,
                                                const SurfaceDistanceOptions& options, const Executor& executor);

}  // namespace foredraw
