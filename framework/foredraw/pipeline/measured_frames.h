#pragma once
#include <foredraw/pipeline/pipeline.h>
#include <foredraw/technique/registry.h>

namespace foredraw {

/// What of the set is not as usual, by its words.
Settings settings_of(const FrameSet& frames);

/// Evaluators of frames, which have all words of a set of frames as options, take those that they do not say from the
/// pipeline's.
void walk_frames_of(const FrameSet& frames, std::vector<Stage>& measures, const Registry& registry);

}  // namespace foredraw
