#pragma once
// The sides of a scene's double-sided draws that are seen, in all poses.

#include "needed_sides.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/poses.h>

#include <map>

namespace foredraw::sides {

struct SideSearchOptions {
  int rays = 16;     ///< for a side that no picture shows, and that touches one that is seen; shared out over the poses
  int checks = 150;  ///< pictures that have the last word, from sides and at times that decided nothing
  Views views;       ///< that the first pictures are drawn from; several poses share them
  Poses poses = rest_pose;
  SubjectUnit subjects = SubjectUnit::character;  ///< what hides what: parts of one subject
  std::uint64_t seed = 0;
};

struct FoundSides {
  std::map<DrawId, std::vector<Side>> wanted;  ///< [draw asked for][triangle]
  std::map<DrawId, bool> is_closed;            ///< [draw asked for] every component of it is closed and faces outwards
  Needed last_check;  ///< pixels that the last pictures still added a side for, of all they show
};

/// First pictures are drawn from the views, in the poses. Then rays are cast for what they do not show (but not from
/// the backs of closed components): few from every side, and many from those that touch a side that is seen, for as
/// long as more are found: what is seen through an opening lies together, and what touches it counts as seen. Then
/// pictures from other views and in other poses are drawn, until these change nothing, six times at most. Fronts
/// count as seen, unless only the back of the triangle is.
FoundSides find_sides(const Scene& scene, std::span<const DrawId> asked, const SideSearchOptions& options,
                      Analyses& analyses, const Executor& executor);

}  // namespace foredraw::sides
