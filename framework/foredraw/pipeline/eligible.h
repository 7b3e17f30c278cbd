#pragma once
// Whether a stage may work on a draw. The planner asks before anything runs, the runner again when the stage's turn comes.

#include <foredraw/pipeline/plan.h>

namespace foredraw {

/// The draws that a stage works on, and those that it leaves alone. `traits` holds each draw's, as they are or as earlier
/// stages will leave them.
struct Choice {
  std::vector<DrawId> draws;
  std::vector<Skip> skips;
};
Choice choose(const PlannedStage& stage, const Scene& scene, const std::vector<Traits>& traits);

/// The traits in `wanted` that are not in `held`, as "clustered" or "uv0 and normals".
std::string missing(const Traits& wanted, const Traits& held);

/// The traits after the stage has worked on a draw.
Traits after_stage(const Card& card, Traits traits);

}  // namespace foredraw
