#pragma once
// What shows nothing, left out.

#include <foredraw/scene/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace foredraw {

/// A stream's name, and why it is not needed.
struct PrunedStream {
  std::string semantic;
  std::string why;
};

struct PrunedStreams {
  std::shared_ptr<const VertexStreams> vertices;  ///< the same where nothing is left out
  std::vector<PrunedStream> pruned;
};

/// Streams that change nothing of what is shown: colours that are 1 everywhere, further sets of joints whose weights
/// are all 0, and, where it is told what materials need, texture coordinates and tangents beyond that. Sets of texture
/// coordinates are numbered without a gap, so only the last ones go. O(vertices).
PrunedStreams prune_streams(const VertexStreams& vertices, const std::optional<VertexNeeds>& needs = std::nullopt);

/// What the draw's material needs, with textures that stages gave it; nothing where it may need anything: it has no
/// material, so whoever shows it puts one there, or the draw has an extension that we do not know.
std::optional<VertexNeeds> needs_of(const Draw& draw, const Scene& scene);

/// How far a track may be from where its node rests, to count as resting there.
struct RestTolerances {
  double translation = 0;  ///< distance, in the units of the node's parent
  double rotation = 1e-4;  ///< distance of unit quaternions; half of the angle in radians
  double scale = 1e-5;     ///< of each component
};

/// [channel] whether it can be left out: all its keys say what the node has at rest. One channel stays at least, and
/// one that lasts as long as the animation. Channels of morph weights stay.
std::vector<bool> resting_tracks(const Animation& animation, const std::vector<Node>& nodes,
                                 const RestTolerances& tolerances);

struct Plugin;
Plugin prune_plugin();

}  // namespace foredraw
