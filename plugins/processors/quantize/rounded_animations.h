#pragma once
// Keys of animations rounded, and those left out that lie between their neighbours anyway.

#include <foredraw/scene/scene.h>

#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// The most that what an animation moves may be off at any of its keys; at 0 it stays as it is.
struct KeyTolerances {
  double translation = 0;  ///< distance in the world
  double rotation = 0;     ///< degrees
  double scale = 0;        ///< of 1
};

/// The largest errors that there are, at the keys that there were, in the units of KeyTolerances.
struct KeyErrors {
  double translation = 0;
  double rotation = 0;
  double scale = 0;
};

struct RoundedAnimation {
  Animation animation;
  KeyErrors largest;
  std::size_t keys_before = 0, keys_after = 0;  ///< over all channels
};

/// Channels that step, or go linearly, with the same nodes and paths: translations and scales on lattices, rotations as
/// the quaternion filter of meshopt compression gives them. A key is left out where every channel with the same times
/// stays within its tolerance without it; a channel that stands still keeps one key. The first and the last key of the
/// animation stay, so it lasts as long. Cubic splines and morph weights stay as they are. [node] `units`: how long a
/// unit of its parent is in the world, see longest_units(); translations of those of length 0 stay, too.
RoundedAnimation rounded(const Animation& animation, const KeyTolerances& tolerances, std::span<const double> units);

}  // namespace foredraw
