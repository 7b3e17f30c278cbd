#include <foredraw/pipeline/runner.h>

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/plan_runner.h>

#include <algorithm>
#include <utility>

namespace foredraw {

namespace {

/// Whether stages find the same surroundings in both.
bool run_alike(const Pipeline& a, const Pipeline& b) {
  const auto without_stages = [](Pipeline pipeline) {
    pipeline.stages.clear();
    pipeline.measure.clear();
    return pipeline;
  };
  return same_pipeline(without_stages(a), without_stages(b));
}

/// How many stages all plans begin with alike.
std::size_t shared_stages(std::span<const Plan> plans) {
  std::size_t shared = plans.front().stages.size();
  for (const Plan& plan : plans) {
    if (!run_alike(plan.pipeline, plans.front().pipeline)) return 0;
    std::size_t alike = 0;
    while (alike < std::min(shared, plan.stages.size()) &&
           print_stage(plan.stages[alike].stage) == print_stage(plans.front().stages[alike].stage)) {
      ++alike;
    }
    shared = alike;
  }
  return shared;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

Result optimize(const Plan& plan, Scene scene, const Surroundings& surroundings) {
  PlanRunner runner(plan, std::move(scene), surroundings);
  runner.begin(true);
  runner.run_stages(0, plan.stages.size());
  return runner.end();
}

Result measure(const Plan& plan, Scene scene, const Surroundings& surroundings) {
  PlanRunner runner(plan, std::move(scene), surroundings);
  runner.begin(false);
  return runner.end();
}

std::vector<Result> compare(std::span<const Plan> plans, const Scene& scene, int rounds,
                            const Surroundings& surroundings) {
  if (plans.empty()) return {};
  const std::size_t shared = shared_stages(plans);
  Analyses analyses = surroundings.analyses.emptied();
  const Surroundings own{surroundings.executor, analyses, surroundings.cancel, surroundings.progress};
  PlanRunner input(plans.front(), scene, own, true);
  input.begin(true);
  std::vector<Result> results;
  std::vector<std::vector<std::vector<double>>> seconds(plans.size());  // [plan][stage][round]
  for (int round = 0; round < rounds; ++round) {
    analyses.clear();
    PlanRunner common = input;
    common.run_stages(0, shared);
    for (std::size_t p = 0; p < plans.size(); ++p) {
      analyses.clear();
      PlanRunner branch = common;
      branch.go_on_with(plans[p]);
      branch.run_stages(shared, plans[p].stages.size());
      seconds[p].resize(branch.stages().size());
      for (std::size_t s = 0; s < seconds[p].size(); ++s) seconds[p][s].push_back(branch.stages()[s].seconds);
      if (round == 0) results.push_back(branch.end());
    }
  }
  for (std::size_t p = 0; rounds > 1 && p < plans.size(); ++p) {
    for (std::size_t s = 0; s < seconds[p].size(); ++s) {
      results[p].report.stages[s].seconds = median(seconds[p][s]);
      results[p].report.stages[s].rounds = std::move(seconds[p][s]);
    }
  }
  return results;
}

}  // namespace foredraw
