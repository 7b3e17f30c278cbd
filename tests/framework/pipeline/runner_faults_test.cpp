// Techniques that fail: what they were given stays as it was, and the run goes on and tells it.

#include "runs_stages.h"

#include <algorithm>

namespace foredraw::runner_faults_test {
namespace {

class RunnerFaults : public testing::RunsStages {};

using Lines = std::vector<std::string>;

/// "place: message"
Lines told(const Result& result) {
  Lines lines;
  for (const Diagnostic& one : result.report.diagnostics) lines.push_back(one.where.inside + ": " + one.message);
  return lines;
}

class Fault : public RunnerFaults, public ::testing::WithParamInterface<const char*> {};

TEST_P(Fault, KeepsTheDrawAsItWasAndGoesOn) {
  const Result result =
      run(std::string("faulty(on=\"A\", fault=\"") + GetParam() + "\"), reverse-draw(only=\"B\")", two_);
  EXPECT_TRUE(result.failed);
  EXPECT_EQ(indices(result.scene, 0), indices(two_, 0));
  EXPECT_NE(indices(result.scene, 1), indices(two_, 1));
  ASSERT_EQ(result.report.diagnostics.size(), 1u);
  EXPECT_EQ(result.report.diagnostics[0].code, "stage-failed");
  EXPECT_EQ(result.report.diagnostics[0].where.inside, "A");
  EXPECT_EQ(result.report.stages[0].changed, 1u);
}
INSTANTIATE_TEST_SUITE_P(EveryKind, Fault, ::testing::Values("throw", "odd-throw", "short", "repeat"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_F(RunnerFaults, AreToldOfEachDrawThoughDrawsHaveOneName) {
  two_.draws[1].name = "A";
  const Result result = run("faulty(on=\"A\"), reverse-draw", two_);
  EXPECT_EQ(told(result), (Lines{"A: stage 1 'faulty' failed: something went wrong",
                                 "A: stage 1 'faulty' failed: something went wrong"}));
}

struct FailsOnScenes final : Evaluator {
  void evaluate(const Scene&, Run&) const override { throw std::runtime_error("there is nothing to count with"); }
};

TEST_F(RunnerFaults, OfAnEvaluatorOnInputAndOutputAreToldOnce) {
  registry_.add(testing::plugin_of<FailsOnScenes>(Kind::evaluator, {.name = "fails"}));
  const Result result = run("reverse-draw", two_, "fails, count-draws");
  EXPECT_TRUE(result.failed);
  EXPECT_EQ(told(result), Lines{": stage 2 'fails' failed: there is nothing to count with"});
  EXPECT_EQ(result.report.diagnostics[0].hint, "its figures are left out; the run continues");
}

/// Counts draws of two triangles at most.
struct FailsOnLarge final : DrawEvaluator {
  void evaluate(const DrawView& draw, Run& run) const override {
    if (draw.triangle_count() > 2) throw std::runtime_error("it is too large");
    run.count("draws", 1);
  }
};

/// A is too large before and after; B, by then of four triangles and called A as well, is so afterwards alone.
TEST_F(RunnerFaults, OfAnEvaluatorOnTheOutputAloneAreTold) {
  registry_.add(testing::plugin_of<FailsOnLarge>(Kind::evaluator,
                                                 {.name = "small-alone", .metrics = {{"draws", "draws", "Small"}}}));
  const Lines once{"A: stage 2 'small-alone' failed: it is too large"};
  EXPECT_EQ(told(run("reverse-draw", two_, "small-alone")), once);
  two_.draws[1].name = "A";
  const Lines twice{once[0], once[0]};
  EXPECT_EQ(told(run("double-triangles", two_, "small-alone")), twice);
}

/// Measuring alone is the output's: there is nothing before.
TEST_F(RunnerFaults, OfAnEvaluatorAloneAreToldOfEachDraw) {
  registry_.add(testing::plugin_of<FailsOnLarge>(Kind::evaluator, {.name = "small-alone"}));
  const Scene scene = testing::scene_of({two_.draws[0], two_.draws[0]});
  const Executor executor(2);
  Analyses analyses;
  const Result result = measure(planned("", scene, "small-alone"), scene, {executor, analyses});
  EXPECT_EQ(result.report.diagnostics.size(), 2u);
}

}  // namespace
}  // namespace foredraw::runner_faults_test
