#pragma once
// Runs a plan. Draws are worked on in parallel; a stage that fails on a draw leaves it as it was; the result is the
// same at any thread count.

#include <foredraw/pipeline/plan.h>

#include <atomic>
#include <functional>
#include <span>
#include <vector>

namespace foredraw {

/// What a run lives on. Analyses may be shared between runs.
struct Surroundings {
  const Executor& executor;
  Analyses& analyses;
  const std::atomic<bool>* cancel = nullptr;
  /// Called as stages begin and end: what is going on, and which part of the whole is done, 0 to 1. May be empty.
  std::function<void(std::string_view, double)> progress = {};
};

struct Result {
  Scene scene;
  Report report;
  bool failed = false;  ///< some stage failed somewhere; the report says where
};

/// Measures, runs the stages, measures again.
Result optimize(const Plan& plan, Scene scene, const Surroundings& surroundings);

/// Measures once; the plan's stages are not run.
Result measure(const Plan& plan, Scene scene, const Surroundings& surroundings);

/// The same scene in several plans, which all measure as the first one does: [plan]. The input is measured once, and
/// the stages that all plans begin with alike run once. Stages run in so many rounds, every plan once in each, and none
/// lives on analyses that another one made, nor on those of the surroundings: a stage's time is the median of its
/// rounds. Of no plans there are no results.
std::vector<Result> compare(std::span<const Plan> plans, const Scene& scene, int rounds,
                            const Surroundings& surroundings);

}  // namespace foredraw
