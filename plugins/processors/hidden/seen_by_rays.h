#pragma once
// Triangles that a camera sees, asked one by one: whether a ray from some point of them gets to where cameras are.

#include "seen_in_pictures.h"
#include "sight.h"

#include <foredraw/analysis/ray_tree.h>
#include <foredraw/viewing/bounding_sphere.h>

#include <optional>

namespace foredraw::processors::hidden {

/// Rays of a triangle: those numbered from `first` on.
struct RayRange {
  std::size_t first = 0, count = 0;
  std::uint64_t seed = 0;
};

/// A triangle of the sight, and a direction from it that is free, or may be.
struct WayOut {
  std::uint32_t number = 0;
  glm::dvec3 direction{0};
};

class Rays {
 public:
  explicit Rays(const Sight& sight);

  /// Flags in `seen` those of the triangles `asked` of which a ray gets away: out of everything, or to a camera inside.
  /// A triangle of a single-sided part sends rays from its front alone. One of no area is not seen; one whose area is
  /// not finite is. Returns these triangles, rising, with the ways that their rays took.
  std::vector<WayOut> add_seen(const RayRange& rays, const Flags& asked, Flags& seen, const Executor& executor) const;

  /// Tries ways out, near enough, from points all over their triangles. Returns those that are free.
  std::vector<WayOut> add_seen_along(std::span<const WayOut> ways, std::uint64_t seed, Flags& seen,
                                     const Executor& executor) const;

  /// Flags what pictures all around show, of `size` x `size` for each of six sides, from so many places in the boxes
  /// that cameras are in. Of equally near triangles one counts.
  Pixels add_seen_around(std::size_t places, int size, std::uint64_t seed, const Flags& asked, Flags& seen,
                         const Executor& executor) const;

 private:
  struct Place {
    std::size_t part = 0, triangle = 0;  ///< of the part
  };
  std::optional<glm::dvec3> way_out(std::uint32_t number, const RayRange& rays) const;
  std::optional<glm::dvec3> way_out_along(const WayOut& way, std::uint64_t seed) const;
  template <class Questions, class Ask>
  std::vector<WayOut> found(const Questions& questions, const Ask& ask, Flags& seen, const Executor& executor) const;
  bool gets_out(const RayTree::Ray& ray) const;
  bool gets_to_camera(const RayTree::Ray& ray) const;

  const Sight& sight_;
  RayTree tree_;
  BoundingSphere sphere_;
  std::vector<Place> places_;  ///< [triangle of the sight]
};

}  // namespace foredraw::processors::hidden
