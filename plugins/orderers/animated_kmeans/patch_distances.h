#pragma once
// Where the patches of a subject are in each pose, and from where they are seen: what sorting by distance asks.

#include <foredraw/base/parallel.h>
#include <foredraw/overdraw/subject_layers.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/raster_part.h>

#include <cstddef>
#include <span>
#include <vector>

namespace foredraw {

/// A sum of distances and of the weights of the looks that they are from.
struct IntegratedDistance {
  double distance = 0;
  double looks = 0;
};

/// Patches are the owners of a SubjectLayers's layers; looks are its looks. Distances are in radii of the subject's
/// bounding sphere in the look's pose; where a view is orthographic, along its direction from the plane through the
/// centre. Of each pose the centroids of the patches are kept, of each look one bit a patch.
class PatchDistances {
 public:
  explicit PatchDistances(std::span<const View> views) : views_(views) {}  ///< of every pose; they must outlive this

  /// The next pose. `parts`: as the subject's owners tell them, with those that are not drawn.
  void add_pose(const SubjectLayers& subject, std::span<const RasterPart> parts, const Executor& executor);

  double distance(std::size_t look, std::size_t patch) const;
  /// Whether a triangle of the patch turns its front to the camera, or one that is seen from behind too is there.
  bool is_facing(std::size_t look, std::size_t patch) const { return facing_[look][patch]; }

  /// Adds, of every patch that is facing there, the distance in the look, so heavy as the look is.
  void integrate(std::size_t look, double weight, std::span<IntegratedDistance> patches) const;

 private:
  const View& view_of(std::size_t look) const { return views_[look % views_.size()]; }

  std::span<const View> views_;
  std::vector<std::vector<glm::dvec3>> centroids_;  // [pose][patch]
  std::vector<std::vector<bool>> facing_;           // [look][patch]
};

}  // namespace foredraw
