#pragma once
// Rays from sides of triangles: what leaves the subject unblocked is seen by a camera out there.

#include "all_sides.h"
#include "surface.h"

#include <foredraw/analysis/ray_tree.h>
#include <foredraw/base/parallel.h>

#include <cstdint>
#include <vector>

namespace foredraw::processors::sides {

/// A side of a triangle, and whence it is seen.
struct Seen {
  std::uint32_t part = 0, triangle = 0;
  Side side = front;
  glm::dvec3 direction{0, 0, 1};  ///< from the side to a camera that sees it; of any length above 0
};

/// A subject in a pose, as rays ask about it. What it refers to must outlive it.
class SideRays {
 public:
  /// `surfaces`: [part] none where the part is not asked about.
  SideRays(std::span<const RasterPart> parts, std::vector<const Surface*> surfaces, const Executor& executor);

  /// Casts `rays` rays from each of the sides `asked` ([part][triangle]), from points all over it: by turns anywhere,
  /// and through an opening of the component that the triangle is of, near its rim. Those that are seen.
  std::vector<Seen> through_openings(const SidesOfParts& asked, std::size_t rays, std::uint64_t seed) const;

  /// Asks what touches a side that is seen, and is not in `kept` yet, whether it is seen from about the same direction;
  /// adds it to `kept` where it is, and goes on from there until nothing more is found. Those that were added.
  std::vector<Seen> beside(std::vector<Seen> seen, SidesOfParts& kept, std::uint64_t seed) const;

 private:
  struct Question;
  bool escapes(const Question& question, const glm::dvec3& from, const glm::dvec3& direction) const;

  std::span<const RasterPart> parts_;
  std::vector<const Surface*> surfaces_;
  std::vector<std::uint32_t> first_{0};  ///< [part] its first triangle in the tree
  RayTree tree_;
  const Executor& executor_;
};

}  // namespace foredraw::processors::sides
