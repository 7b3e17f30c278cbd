#pragma once
#include <foredraw/base/parallel.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/subject.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// The poses of one subject, of which some may look alike: then it is drawn in the first of them alone.
struct DistinctPoses {
  std::vector<std::size_t> first_alike;  ///< [pose] the first one with the same positions, bit by bit, faces that turn
                                         ///< alike, and the same orders where the subject has several
  std::vector<double> weights;           ///< [pose] of all that look alike, at the first of them; 0 at the others
};

/// Of each subject. Positions are made for one pose and subject at a time on each thread, and only their hash is kept.
std::vector<DistinctPoses> distinct_poses(const Scene& scene, std::span<const Subject> subjects, const Poses& poses,
                                          const Executor& executor);

/// In how many poses some of the subjects look as in none before.
std::size_t count_different(std::span<const DistinctPoses> subjects);

/// "16 poses"; "16 poses (15 different)".
std::string poses_text(std::size_t poses, std::size_t different);

}  // namespace foredraw
