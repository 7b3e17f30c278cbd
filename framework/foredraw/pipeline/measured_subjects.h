#pragma once
#include <foredraw/pipeline/pipeline.h>
#include <foredraw/technique/registry.h>

namespace foredraw {

/// Evaluators that have an option `subject`, and do not say it, judge what the stages see as one.
void judge_subjects_of(const SubjectChoice& subjects, std::vector<Stage>& measures, const Registry& registry);

}  // namespace foredraw
