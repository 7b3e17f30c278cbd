#pragma once
// What no pipeline draws: a buffer for each keyframe, and the least that any buffers could leave.

#include "lab.h"

namespace foredraw::bench {

/// The draws' clusters, each keyframe in a buffer of its own, sorted by the dot rule in the keyframe's positions.
Figures dot_rule_per_keyframe(Lab& lab, const Scene& scene, int keyframes);

/// What the sequence of a character's draws costs, however the triangles of each are ordered. The ratio alone.
Figures least_of_sequence(Lab& lab, const Scene& scene, int keyframes);

}  // namespace foredraw::bench
