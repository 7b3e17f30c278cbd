#pragma once
#include <foredraw/pipeline/pipeline.h>
#include <foredraw/technique/registry.h>

namespace foredraw {

/// What to measure where nobody says: the evaluators that the stages' cards name, each once. Stages that name none, or
/// none that this build has, are measured as @default measures; so is a pipeline without stages.
std::vector<Stage> usual_measures(const std::vector<Stage>& stages, const Registry& registry);

}  // namespace foredraw
