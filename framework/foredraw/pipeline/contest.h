#pragma once
// Several pipelines on one scene, side by side: planned, run and recorded.

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/report/comparison.h>

namespace foredraw {

/// What became of each pipeline. Those that can not be planned for the scene are lost: their branches say why.
struct Contest {
  Comparison comparison;
  std::vector<std::optional<Scene>> scenes;  ///< [pipeline] nothing where it was lost
  std::vector<Diagnostic> warnings;          ///< of planning; those that several pipelines share, once
  bool failed = false;                       ///< some stage failed somewhere
};

/// Runs them all, stages in so many rounds. `input`: of the scene. `lender`: who reads files that options name.
Contest contest(const FileRecord& input, const Scene& scene, std::span<const NamedPipeline> pipelines,
                const Registry& registry, const Lender* lender, int rounds, const Surroundings& surroundings);

/// Lets all of them measure alike: with these evaluators; if there are none with those of the first; or else with what
/// shows the gains of their stages.
void measure_alike(std::vector<NamedPipeline>& pipelines, std::vector<Stage> measure, const Registry& registry);

/// Lets evaluators judge the subjects that the first pipeline's stages see, wherever others see different ones.
void judge_alike(std::vector<NamedPipeline>& pipelines, const Registry& registry);

}  // namespace foredraw
