#pragma once
// Triangles that a camera sees, asked one by one: whether a ray from some point of them gets to where cameras are.

#include "seen_in_pictures.h"
#include "sight.h"

#include <foredraw/analysis/ray_tree.h>
#include <foredraw/viewing/bounding_sphere.h>

namespace foredraw::hidden {

/// Rays of a triangle: those numbered from `first` on.
struct RayRange {
  std::size_t first = 0, count = 0;
  std::uint64_t seed = 0;
};

class Rays {
 public:
  explicit Rays(const Sight& sight);

  /// Flags in `seen` those of the triangles `asked` of which a ray gets away: out of everything, or to a camera inside.
  /// A triangle of a single-sided part sends rays from its front alone. One of no area is not seen; one whose area is
  /// not finite is.
  void add_seen(const RayRange& rays, const Flags& asked, Flags& seen, const Executor& executor) const;

  /// The same by pictures all around of `size` x `size` for each of the six sides, from so many places in the boxes
  /// that cameras are in. Of equally near triangles one counts.
  Pixels add_seen_around(std::size_t places, int size, std::uint64_t seed, const Flags& asked, Flags& seen,
                         const Executor& executor) const;

 private:
  struct Place {
    std::size_t part = 0, triangle = 0;  ///< of the part
  };
  bool is_seen(std::uint32_t number, const Place& place, const RayRange& rays) const;
  bool gets_out(const RayTree::Ray& ray) const;
  bool gets_to_camera(const RayTree::Ray& ray) const;

  const Sight& sight_;
  RayTree tree_;
  BoundingSphere sphere_;
  std::vector<Place> places_;  ///< [triangle of the sight]
};

}  // namespace foredraw::hidden
