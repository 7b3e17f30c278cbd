#pragma once
// What animations make of a scene's nodes.

#include <foredraw/scene/poses.h>

#include <glm/mat4x4.hpp>

#include <vector>

namespace foredraw {

/// Every node at one moment.
struct PosedNodes {
  std::vector<glm::mat4> world;             ///< [node]
  std::vector<std::vector<float>> weights;  ///< [node] of the morph targets that it shows
};

/// Evaluates a clip as glTF 2.0, appendix C, says: LINEAR (rotations along the shortest arc), STEP, CUBICSPLINE; what
/// it does not move stays as it stands. The same bits on every machine. Channels that have no keys, too few values, or
/// no node, and those that move a node whose transform is given as a matrix, are left out; a rotation of length 0 turns
/// nothing.
PosedNodes posed_nodes(const Scene& scene, const Pose& pose = {});

/// All clips at once, each from its beginning again when it has ended; where two move the same, the later one does.
PosedNodes posed_nodes_of_all_clips(const Scene& scene, double seconds);

/// Whether a channel has keys, and values for all of them.
bool has_keys(const AnimationChannel& channel);

}  // namespace foredraw
