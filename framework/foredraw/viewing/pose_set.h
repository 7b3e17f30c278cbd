#pragma once
// Pose sets: in which poses a subject is looked at, spelled alike in every pipeline table and option list.

#include <foredraw/scene/poses.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// A pose set as a pipeline spells it.
struct PoseSet {
  /// auto: 16 poses at most, spread evenly over the clips, which share the views out among them (Poses::share_views).
  /// bind: as the nodes stand. all: every clip at each of its keys. A number: so many poses at most, spread evenly.
  std::string poses = "auto";
  std::string clips = "*";     ///< names of the clips to look at, with * and ?
  std::optional<double> rate;  ///< in place of `poses`: so many a second, from each clip's first key on
  std::string moments;         ///< in place of `poses`: seconds, "0 0.5 2"; a clip takes those that it lasts for

  friend bool operator==(const PoseSet&, const PoseSet&) = default;
};

/// Why the set can not be made of any scene ("rate is 0, ..."), or nothing.
std::optional<std::string> mistake_in(const PoseSet& set);

/// The poses of a set without mistakes: clips in the scene's sequence, each from its beginning to its end. Clips
/// without keys have none. At rest where there are none at all. std::invalid_argument where the set has a mistake, or
/// where the scene has more than 100000 such poses.
Poses make_poses(const Scene& scene, const PoseSet& set);

/// Why a scene with clips that have keys is at rest all the same, though the set asks for poses ("no clip is called
/// 'Wlak'; did you mean 'Walk'?"), or nothing.
std::optional<std::string> why_at_rest(const Scene& scene, const PoseSet& set);

/// Every clip by a name of its own: its name in the file or "animation3"; the second of a name is "Walk#2".
std::vector<std::string> clip_names(const Scene& scene);

/// "Walk@0.25", "rest".
std::string pose_name(const Pose& pose, const std::vector<std::string>& clip_names);

}  // namespace foredraw
