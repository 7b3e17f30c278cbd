#pragma once
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>

namespace foredraw {

/// How many times longer a line of the part's draw becomes at most where its node shows it: exact where transforms only
/// turn and scale along their own axes, else a little more. 1 without a node. Of a skinned draw the most that one of
/// the joints stretches. `nodes`: posed_nodes() of the scene; not read without a node.
double most_stretch(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes);

}  // namespace foredraw
