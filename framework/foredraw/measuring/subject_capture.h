#pragma once
// A subject captured in poses and from all views, for orderers that judge orders of it without drawing again.

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/overdraw/subject_layers.h>
#include <foredraw/technique/orderer.h>
#include <foredraw/viewing/distinct_poses.h>

#include <functional>

namespace foredraw {

/// Looks are the poses that look different, each from all views in turn, or from its share of them where the poses
/// share them.
struct SubjectCapture {
  SubjectLayers seen;         ///< its indices lie in the scene
  std::vector<DrawId> draws;  ///< [draw of `seen`]
  /// [pose][view] the look that shows it, or the pose from the nearest side that was captured; poses that look alike
  /// share their looks.
  std::vector<std::vector<std::size_t>> look;

  /// The draw's number in `seen`.
  std::size_t number_of(DrawId draw) const;
  /// [look] -> [pose * number of views + view], as order_table() takes it.
  std::vector<std::uint8_t> by_pose(std::span<const std::uint8_t> serving) const;
};

inline constexpr std::size_t every_look = ~std::size_t{0};

/// Captures the subject in the poses and from the run's views, by the run's overdraw service. `atoms_of`: what of the
/// view's draws is moved as one, a partition of the draw's triangles; the subject's other draws are one atom each.
/// `see`, where there is one, is called for every pose that looks different, in their sequence, with what is captured
/// up to it and the subject as it is drawn there. `most_looks`: where there are more, the poses share the views so that
/// there are so many, but one of each pose at least. Positions are made for one pose at a time. std::runtime_error
/// where the service can not capture and where the run is cancelled.
SubjectCapture capture_subject(const SubjectView& view, const Poses& poses,
                               const std::function<Clusters(const Draw&)>& atoms_of, Run& run,
                               const std::function<void(const SubjectLayers&, const SubjectGeometry&)>& see = {},
                               std::size_t most_looks = every_look);

/// Whether some order of a subject that stands still may overdraw more than `least_overdraw`, as overdraw_bound() knows
/// without drawing it. Else tells the run that nothing can be gained. True of subjects that move: each pose has its own
/// hull.
bool may_overdraw(const SubjectView& view, Run& run);

/// Whether anything is drawn that does not stay. Else tells the run that nothing can be gained.
bool has_overdraw(const ViewTally& before, Run& run);

/// Whether the new orders draw less of it. Else tells the run that what there is stays, and why.
bool lowers_overdraw(const ViewTally& before, const ViewTally& after, Run& run);

}  // namespace foredraw
