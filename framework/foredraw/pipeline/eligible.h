#pragma once
// Whether a stage may work on a draw. The planner asks before anything runs, the runner again when the stage's turn
// comes.

#include <foredraw/pipeline/plan.h>

#include <map>

namespace foredraw {

/// The draws that products of the scene hold, and the title of the product that does: "merged draws".
using Holders = std::map<DrawId, std::string>;
Holders holders_of_draws(const Scene& scene, const ProductRows& rows);

/// Why a stage leaves a draw alone that has the traits, as they are or as earlier stages will leave them; nothing where
/// it works on it.
std::optional<Skip> why_not(const PlannedStage& stage, const Scene& scene, DrawId id, const Traits& traits,
                            const Holders& holders);

/// What to name instead, where a stage's `only` names no draw of a scene that has some: their names, or the first of
/// them. Nothing where there is nothing wrong.
std::optional<std::string> names_instead(const Stage& stage, const Scene& scene);

/// The traits in `wanted` that are not in `held`, as "clustered" or "uv0 and normals".
std::string missing(const Traits& wanted, const Traits& held);

/// The traits after the stage has worked on a draw.
Traits after_stage(const Card& card, Traits traits);

}  // namespace foredraw
