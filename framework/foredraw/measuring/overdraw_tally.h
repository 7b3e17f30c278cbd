#pragma once
// Sums over the pictures of an evaluation: by draw, by subject, by pose.

#include <foredraw/measuring/subjects_in_poses.h>
#include <foredraw/overdraw/overdraw_figures.h>

#include <map>

namespace foredraw {

/// What is counted of one thing in all poses.
struct OverdrawTally {
  std::vector<ViewTally> views;
  OverdrawCount worst;  ///< the picture with the highest ratio, the first of them
  double hidden = 0;
  double ties = 0;
  double discarded = 0;

  /// `pictures`: one for each view.
  void add(std::span<const OverdrawCount> pictures, double weight);
};

/// Evaluated poses are told one by one up to so many of them.
inline constexpr std::size_t most_told_poses = 64;

struct OverdrawTallies {
  std::vector<std::map<std::size_t, OverdrawTally>> draws;  ///< [draw] by the subjects that it is in
  std::vector<OverdrawTally> subjects;                      ///< [subject]
  std::vector<std::size_t> non_finite;                      ///< [subject] triangles, in the pose that has most of them
  /// [pose] over all subjects, for each view; one sum over the views where there are too many poses to tell of each.
  /// Views weigh in already.
  std::vector<std::vector<ViewTally>> poses;

  OverdrawTallies(const SubjectsInPoses& subjects, std::size_t views);

  /// What a subject counts in a pose that is new to it: [part][view].
  void add(const SubjectsInPoses& subjects, std::size_t subject, std::size_t pose, const OverdrawCounts& counts,
           std::span<const View> views);
};

}  // namespace foredraw
