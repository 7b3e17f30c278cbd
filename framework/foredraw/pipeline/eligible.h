#pragma once
// Whether a stage may work on a draw. The planner asks before anything runs, the runner again when the stage's turn
// comes.

#include <foredraw/pipeline/plan.h>

namespace foredraw {

/// Why a stage leaves a draw alone that has the traits, as they are or as earlier stages will leave them; nothing where
/// it works on it.
std::optional<Skip> why_not(const PlannedStage& stage, const Scene& scene, DrawId id, const Traits& traits);

/// The traits in `wanted` that are not in `held`, as "clustered" or "uv0 and normals".
std::string missing(const Traits& wanted, const Traits& held);

/// The traits after the stage has worked on a draw.
Traits after_stage(const Card& card, Traits traits);

}  // namespace foredraw
