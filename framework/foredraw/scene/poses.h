#pragma once
// At which moments of its animations a scene is looked at.

#include <foredraw/scene/scene.h>

#include <optional>
#include <vector>

namespace foredraw {

/// All nodes as one clip has them at one moment; without a clip as they stand in the file.
struct Pose {
  std::optional<AnimationId> clip;
  double time = 0;    ///< in the clip, seconds; before its first key and behind its last one the clip stands still
  double weight = 1;  ///< above 0; how much the pose counts beside the others

  friend bool operator==(const Pose&, const Pose&) = default;
};

struct Poses {
  std::vector<Pose> poses = {Pose{}};  ///< one at least
  /// Who looks at each from many sides may look at each from some of them, so that all sides are seen twice in all.
  bool share_views = false;

  friend bool operator==(const Poses&, const Poses&) = default;
};

/// The scene as it stands.
inline const Poses rest_pose;

}  // namespace foredraw
