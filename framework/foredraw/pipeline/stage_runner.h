#pragma once
// Runs one stage: the one place where exceptions of techniques stop, and where answers are checked, applied and
// certified.

#include <foredraw/pipeline/runner.h>

namespace foredraw {

/// Runs a stage or an evaluator on the scene. What it did goes to the record, what went wrong to the diagnostics, and
/// what it measured is returned, in the order of what it is about. `number` is the stage's in the pipeline, from 1: it
/// names the stage in messages and seeds its random numbers. `original`: the scene that the run began with.
std::vector<Measured> run_stage(const PlannedStage& stage, std::size_t number, Scene& scene, const Scene& original,
                                const Plan& plan, const Surroundings& surroundings, StageRecord& record,
                                Diagnostics& diagnostics);

}  // namespace foredraw
