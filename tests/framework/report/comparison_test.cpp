#include <foredraw/report/comparison.h>
#include <foredraw/report/pareto.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace foredraw {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

Figure ratio(double numerator, double denominator, bool lower_is_better = true) {
  return {numerator, denominator, 0, "per triangle", lower_is_better};
}

Branch branch(std::string name, const Figure& acmr, double seconds) {
  Branch branch{std::move(name), {}};
  branch.report.optimized = true;
  branch.report.before.metrics.set("cache", "acmr", ratio(3, 1));
  branch.report.after.metrics.set("cache", "acmr", acmr);
  StageRecord stage;
  stage.use = "tipsify";
  stage.seconds = seconds;
  branch.report.stages = {stage, stage};
  return branch;
}

Comparison two_branches() { return {{"in.glb", 100}, {branch("A", ratio(2, 1), 0.25), branch("B", ratio(1, 1), 0.5)}}; }

/// The line that begins with the words, or an empty one.
std::string line_with(const std::string& text, const std::string& words) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(words) != std::string::npos) return line;
  }
  return "";
}

TEST(ComparisonText, AColumnForEachBranchAndAStarAtTheBest) {
  const std::string text = to_text({two_branches()});
  EXPECT_THAT(text, HasSubstr("in.glb\n  [1] A\n  [2] B\n"));
  EXPECT_EQ(line_with(text, "acmr"), "cache  acmr        3.0000  2.0000    1.0000 -50.0 % *");
  EXPECT_EQ(line_with(text, "all stages"), "time   all stages          500.0 ms  1000.0 ms");
  EXPECT_THAT(text, HasSubstr("  [1] tipsify 250.0 ms, tipsify 250.0 ms"));
  EXPECT_THAT(text, HasSubstr("* the best of its row"));
}

TEST(ComparisonText, DifferencesWithinTheErrorsAreNone) {
  Comparison comparison = two_branches();
  Figure near = ratio(2.01, 1);
  near.error = 0.01;
  comparison.branches[1].report.after.metrics.set("cache", "acmr", near);
  EXPECT_THAT(line_with(to_text({comparison}), "acmr"), HasSubstr("2.0100 ±0.0100 ~"));
  near.error = 0.004;
  comparison.branches[1].report.after.metrics.set("cache", "acmr", near);
  EXPECT_THAT(line_with(to_text({comparison}), "acmr"), HasSubstr("2.0100 ±0.0040 +0.5 %"));
}

TEST(ComparisonText, RoundsTellHowSureTimesAre) {
  Comparison comparison = two_branches();
  comparison.branches[0].report.stages[0].rounds = {0.2, 0.25, 0.6};
  comparison.branches[0].report.stages[1].rounds = {0.2, 0.25, 0.6};
  comparison.branches[1].report.stages[0].rounds = {0.5, 0.5, 0.5};
  comparison.branches[1].report.stages[1].rounds = {0.5, 0.5, 0.5};
  const std::string text = to_text({comparison});
  EXPECT_THAT(text, HasSubstr("  [1] tipsify 250.0 ms, tipsify 250.0 ms; 400.0 to 1200.0 ms\n"));
  EXPECT_THAT(text, HasSubstr("; 1000.0 to 1000.0 ms, slower than [1] in 2 of 3 rounds\n"));
}

TEST(ComparisonText, FrontsAreToldOfThreeBranches) {
  Comparison comparison = two_branches();
  const auto judged = [&](std::string name, double acmr, double overdraw, double seconds) {
    Branch made = branch(std::move(name), ratio(acmr, 1), seconds);
    made.report.after.metrics.set("vertex-cache", "acmr", ratio(acmr, 1));
    made.report.after.metrics.set("overdraw-raster", "ratio", ratio(overdraw, 1));
    return made;
  };
  comparison.branches = {judged("fast", 0.7, 1.3, 0.1), judged("good", 0.8, 1.1, 0.3), judged("bad", 0.9, 1.2, 0.4)};
  const std::string text = to_text({comparison});
  EXPECT_THAT(text, HasSubstr("not beaten in both vertex-cache acmr and overdraw-raster ratio: [1] [2]\n"));
  EXPECT_THAT(text, HasSubstr("not beaten in both time and overdraw-raster ratio: [1] [2]\n"));
  EXPECT_THAT(to_text({two_branches()}), Not(HasSubstr("beaten")));
}

TEST(ParetoFront, IsWhatNoneBeatsInBoth) {
  using Points = std::vector<std::pair<double, double>>;
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(pareto_front(Points{}), Numbers{});
  EXPECT_EQ(pareto_front(Points{{1, 3}, {2, 2}, {3, 3}, {3, 1}, {2, 2}, {1, 4}}), (Numbers{0, 1, 3, 4}));
  EXPECT_EQ(pareto_front(Points{{std::nan(""), 0}, {0, INFINITY}, {5, 5}}), Numbers{2});
}

TEST(ComparisonText, TheInputMayBeTheBest) {
  Comparison comparison = two_branches();
  for (Branch& branch : comparison.branches) branch.report.after.metrics.set("cache", "acmr", ratio(4, 1));
  EXPECT_THAT(line_with(to_text({comparison}), "acmr"), HasSubstr("3.0000 *"));
}

TEST(ComparisonText, HigherMayBeBetter) {
  Comparison comparison = two_branches();
  for (std::size_t i = 0; i < 2; ++i) {
    Report& report = comparison.branches[i].report;
    report.before.metrics.set("cache", "hits", ratio(1, 4, false));
    report.after.metrics.set("cache", "hits", ratio(3 - static_cast<double>(i), 4, false));
  }
  EXPECT_THAT(line_with(to_text({comparison}), "hits"), HasSubstr("0.7500 *"));
}

TEST(ComparisonText, NoStarWhereAllAreEqual) {
  Comparison comparison = two_branches();
  for (Branch& branch : comparison.branches) branch.report.after.metrics.set("cache", "acmr", ratio(3, 1));
  EXPECT_THAT(line_with(to_text({comparison}), "acmr"), Not(HasSubstr("*")));
}

TEST(ComparisonText, DashWhereNobodyMeasured) {
  Comparison comparison = two_branches();
  comparison.branches[0].report.after.metrics = {};
  comparison.branches[1].report.after.metrics.set("overdraw", "ratio", ratio(0, 0));
  const std::string text = to_text({comparison});
  EXPECT_EQ(line_with(text, "acmr"), "cache     acmr        3.0000  -         1.0000 *");
  EXPECT_EQ(line_with(text, "ratio"), "overdraw  ratio       -       -         -");
}

TEST(ComparisonText, GroupsAreLeftToTheJsonForm) {
  Comparison comparison = two_branches();
  comparison.branches[0].report.after.metrics.set("cache", "models.amd.acmr", ratio(1, 1));
  EXPECT_THAT(to_text({comparison}), Not(HasSubstr("models")));
}

TEST(ComparisonJson, HoldsWholeReportsAndATableOfMetrics) {
  Comparison comparison = two_branches();
  comparison.branches[0].report.after.metrics.set("cache", "models.amd.acmr", ratio(7, 2));
  const json all = json::parse(to_json({comparison, two_branches()}));
  EXPECT_EQ(all["comparison"], 1);
  ASSERT_EQ(all["files"].size(), 2u);
  const json& file = all["files"][0];
  EXPECT_EQ(file["input"], json::parse(R"({"path": "in.glb", "bytes": 100})"));
  EXPECT_EQ(file["branches"][1]["name"], "B");
  EXPECT_EQ(file["branches"][1]["seconds"], 1.0);
  EXPECT_EQ(file["branches"][1]["report"]["report"], report_version);
  EXPECT_EQ(file["metrics"], json::parse(R"([
    {"evaluator": "cache", "metric": "acmr", "input": 3.0, "values": [2.0, 1.0]},
    {"evaluator": "cache", "metric": "models.amd.acmr", "input": null, "values": [3.5, null]}])"));
}

TEST(ComparisonJson, NothingComparedIsNoFiles) {
  EXPECT_EQ(json::parse(to_json(std::vector<Comparison>{}))["files"], json::array());
}

}  // namespace
}  // namespace foredraw
