#pragma once
#include <foredraw/viewing/distinct_poses.h>

#include <algorithm>

namespace foredraw {

/// What an evaluator of a scene looks at: its subjects, in poses.
struct SubjectsInPoses {
  const Scene& scene;
  std::vector<Subject> subjects;
  Poses poses;
  std::vector<DistinctPoses> distinct;  ///< [subject]

  /// Whether the subject looks as in no pose before this one. Else there is nothing to draw.
  bool is_new(std::size_t subject, std::size_t pose) const { return distinct[subject].first_alike[pose] == pose; }

  /// Whether the subject looks different in some poses.
  bool moves(std::size_t subject) const {
    const auto& first = distinct[subject].first_alike;
    return std::any_of(first.begin(), first.end(), [](std::size_t pose) { return pose > 0; });
  }
};

}  // namespace foredraw
