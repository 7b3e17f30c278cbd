#pragma once
// What stands in the report of a run: the draws as they were and as they are, what was measured of them, and with which
// plan.

#include <foredraw/pipeline/runner.h>

namespace foredraw {

/// The result of a stage or a measurement, beside the scene.
struct Step {
  StageRecord record;
  std::vector<Measured> measured;
};

/// Which state of the scene a figure is of.
enum class SceneState { input, output };

/// The input's draws, with what is odd about them.
void describe_input(const Scene& scene, const Surroundings& surroundings, Report& report);

/// The draws as all stages left them.
void describe_output(const Scene& scene, Report& report);

/// The pipeline's text, and what it was read from and with.
void describe_plan(const Plan& plan, Report& report);

/// Each figure goes to its draw, and to the total: that of the stage, as it names one, or the sum over draws. `draws`:
/// how many the scene has by now.
void book(const std::vector<Measured>& figures, const PlannedStage& stage, SceneState of, std::size_t draws,
          Report& report);

/// What the plan's evaluators found: [measure].
void book_measures(std::vector<Step> steps, const Plan& plan, SceneState of, std::size_t draws, Report& report);

}  // namespace foredraw
