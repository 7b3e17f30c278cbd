// Several plans on one scene.

#include "runs_stages.h"

#include <algorithm>

namespace foredraw::runner_compare_test {
namespace {

class RunnerCompare : public testing::RunsStages {};

TEST_F(RunnerCompare, ComparesPlansAsIfEachRanAlone) {
  const std::vector<std::string> lines = {"pairs, reverse-draw", "pairs",
                                          "pairs, faulty(fault=\"throw\"), reverse-vertices"};
  std::vector<Plan> plans;
  for (const std::string& line : lines) plans.push_back(planned(line, two_, "count-triangles"));
  const Executor executor(2);
  Analyses analyses;
  for (const int rounds : {1, 4}) {
    const std::vector<Result> compared = compare(plans, two_, rounds, {executor, analyses});
    ASSERT_EQ(compared.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Result alone = run(lines[i], two_, "count-triangles");
      for (DrawId draw = 0; draw < 2; ++draw) EXPECT_EQ(indices(compared[i].scene, draw), indices(alone.scene, draw));
      EXPECT_EQ(compared[i].failed, alone.failed);
      EXPECT_EQ(compared[i].report.diagnostics.size(), alone.report.diagnostics.size());
      EXPECT_EQ(compared[i].report.pipeline, alone.report.pipeline);
      EXPECT_EQ(compared[i].report.before.metrics.all().size(), alone.report.before.metrics.all().size());
      ASSERT_EQ(compared[i].report.stages.size(), alone.report.stages.size());
      for (const StageRecord& stage : compared[i].report.stages) {
        ASSERT_EQ(stage.rounds.size(), rounds == 1 ? 0u : 4u);
        if (rounds == 1) continue;
        std::vector<double> sorted = stage.rounds;
        std::ranges::sort(sorted);
        EXPECT_EQ(stage.seconds, (sorted[1] + sorted[2]) / 2);
      }
    }
    EXPECT_EQ(compared[0].report.stages[0].seconds, compared[1].report.stages[0].seconds);  // it ran for all of them
  }
}

TEST_F(RunnerCompare, ComparingLeavesTheAnalysesOfItsCallerAlone) {
  const std::vector<Plan> plans = {planned("pairs", two_)};
  const Executor executor(2);
  Analyses analyses;
  positions_of(analyses, *two_.draws[0].levels[0].vertices);
  compare(plans, two_, 2, {executor, analyses});
  EXPECT_EQ(analyses.size(), 1u);
}

TEST_F(RunnerCompare, ComparingNoPlansGivesNoResults) {
  const Executor executor(1);
  Analyses analyses;
  EXPECT_TRUE(compare({}, two_, 1, {executor, analyses}).empty());
}

}  // namespace
}  // namespace foredraw::runner_compare_test
