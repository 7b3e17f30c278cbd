#include <foredraw/report/comparison.h>
#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace foredraw::comparison_test {
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
  EXPECT_THAT(text, HasSubstr("* best of its row; per cent"));
}

TEST(ComparisonText, CountsOfWhatIsLeftOutAreNotCompared) {
  Comparison comparison = two_branches();
  for (std::size_t i = 0; i < 2; ++i) {
    Figure left_out{static_cast<double>(i + 1), std::nullopt, 0, "draws"};
    left_out.is_neutral = true;
    comparison.branches[i].report.after.metrics.set("cache", "left-out", left_out);
  }
  EXPECT_EQ(line_with(to_text({comparison}), "left-out"), "       left-out    -       1         2");
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

/// The text of [2]'s cell, of a count or a ratio that the baseline has a thousand of.
std::string beside_a_thousand(double value, std::optional<double> denominator, double error = 0) {
  Comparison comparison = two_branches();
  comparison.branches[0].report.after.metrics.set("cache", "x", {1000, denominator, 0, ""});
  comparison.branches[1].report.after.metrics.set("cache", "x", {value, denominator, error, ""});
  return difference_text(total_rows(comparison)[1].branches[1], baseline_of(total_rows(comparison)[1]));
}

TEST(DifferenceText, SaysSameWhereAPerCentWouldBeZero) {
  EXPECT_EQ(beside_a_thousand(1000, 1), "same");
  EXPECT_EQ(beside_a_thousand(999.6, 1), "same");
  EXPECT_EQ(beside_a_thousand(999.4, 1), "-0.1 %");
  EXPECT_EQ(beside_a_thousand(999.6, 1, 0.3), "~");
  EXPECT_EQ(beside_a_thousand(1000, std::nullopt), "same");
  EXPECT_EQ(beside_a_thousand(10000, std::nullopt), "+900.0 %");
}

TEST(DifferenceText, OfExactCountsThatHardlyDifferIsHowMany) {
  Figure before{100000, std::nullopt, 0, ""}, after{100002, std::nullopt, 0, ""};
  EXPECT_EQ(difference_text(&after, &before), "+2");
  after.error = 0.5;
  EXPECT_EQ(difference_text(&after, &before), "same");
  EXPECT_EQ(difference_text(&before, &before), "");
  EXPECT_EQ(difference_text(&after, nullptr), "");
}

TEST(ComparisonText, OfOnePipelineHasNoBest) {
  Comparison comparison = two_branches();
  comparison.branches.pop_back();
  comparison.fronts = {{"time", "cache.acmr"}};
  const std::string text = to_text({comparison});
  EXPECT_EQ(line_with(text, "acmr"), "cache  acmr        3.0000  2.0000");
  EXPECT_THAT(text, Not(HasSubstr("*")));
  EXPECT_THAT(text, Not(HasSubstr("per cent")));
  EXPECT_THAT(text, Not(HasSubstr("trade-offs")));
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
  EXPECT_THAT(text, HasSubstr("best trade-offs of vertex-cache acmr and overdraw-raster ratio: [1] [2]\n"));
  EXPECT_THAT(text, HasSubstr("best trade-offs of time and overdraw-raster ratio: [1] [2]\n"));
  EXPECT_THAT(to_text({two_branches()}), Not(HasSubstr("trade-offs")));
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
  const json all = json::parse(to_json(std::vector{comparison, two_branches()}));
  EXPECT_EQ(all["comparison"], 1);
  ASSERT_EQ(all["files"].size(), 2u);
  const json& file = all["files"][0];
  EXPECT_EQ(file["input"], json::parse(R"({"path": "in.glb", "bytes": 100})"));
  EXPECT_EQ(file["branches"][1]["name"], "B");
  EXPECT_EQ(file["branches"][1]["seconds"], 1.0);
  EXPECT_EQ(file["branches"][1]["report"]["report"], report_version);
  EXPECT_EQ(file["metrics"], json::parse(R"([
    {"evaluator": "cache", "metric": "acmr", "lower-is-better": true, "input": 3.0, "values": [2.0, 1.0]},
    {"evaluator": "cache", "metric": "models.amd.acmr", "lower-is-better": true, "input": null, "values": [3.5, null]}])"));
}

/// A comparison whose first pipeline could not be planned.
Comparison with_a_lost_branch() {
  Comparison comparison = two_branches();
  Branch lost{"odd", {}, true};
  lost.report.diagnostics = {{Severity::error, {}, "unknown-plugin", "there is no plugin 'odd'", ""}};
  comparison.branches.insert(comparison.branches.begin(), lost);
  return comparison;
}

TEST(LostBranch, KeepsItsNumberAndLosesNoOther) {
  const std::string text = to_text({with_a_lost_branch()});
  EXPECT_THAT(text, HasSubstr("  [1] odd\n  [2] A\n  [3] B\n"));
  EXPECT_EQ(line_with(text, "acmr"), "cache  acmr        3.0000  -    2.0000    1.0000 *");
  EXPECT_EQ(line_with(text, "all stages"), "time   all stages          -    500.0 ms  1000.0 ms");
  EXPECT_THAT(text, HasSubstr("  [1] could not be planned\n"));
  const json branch = json::parse(to_json(std::vector{with_a_lost_branch()}))["files"][0]["branches"][0];
  EXPECT_EQ(branch["lost"], true);
  EXPECT_EQ(branch["seconds"], nullptr);
  EXPECT_EQ(branch["report"]["diagnostics"][0]["code"], "unknown-plugin");
  EXPECT_EQ(value_of(with_a_lost_branch().branches[0], "time"), std::nullopt);
  EXPECT_EQ(input_value(with_a_lost_branch(), "cache.acmr"), 3.0);
}

TEST(ComparisonText, ManyBranchesAreARowEach) {
  Comparison comparison = two_branches();
  for (int i = 0; i < 5; ++i) comparison.branches.push_back(branch("more", ratio(4 + i, 1), 0.1));
  for (Branch& one : comparison.branches) one.report.after.metrics.set("cache", "draws", {3, std::nullopt, 0, "draws"});
  const std::string text = to_text({comparison});
  EXPECT_EQ(line_with(text, "cache acmr"), "       cache acmr        time") << "counts are left out";
  EXPECT_EQ(line_with(text, "input "), "input  3.0000");
  EXPECT_EQ(line_with(text, "[2]    "), "[2]    1.0000 -50.0 % *  1000.0 ms");
  EXPECT_EQ(line_with(text, "[7]    "), "[7]    8.0000 +300.0 %   200.0 ms");
  EXPECT_THAT(text, HasSubstr("* best of its column"));
}

TEST(Fronts, AreTheOnesAskedFor) {
  Comparison comparison = two_branches();
  comparison.fronts = {{"time", "cache.acmr"}, {"time", "cache.nothing"}};
  const auto fronts = fronts_of(comparison);
  ASSERT_EQ(fronts.size(), 1u);
  EXPECT_EQ(fronts[0].branches, (std::vector<std::size_t>{0, 1}));
  EXPECT_THAT(to_text({comparison}), HasSubstr("best trade-offs of time and cache acmr: [1] [2]\n"));
  EXPECT_EQ(json::parse(to_json(std::vector{comparison}))["files"][0]["fronts"],
            json::parse(R"([{"x": "time", "y": "cache.acmr", "branches": [0, 1]}])"));
  EXPECT_EQ(unknown_figures(comparison), std::vector<std::string>{"cache.nothing"});
}

TEST(Fronts, OfWhatIsBetterHigherTheHighestIsOnThem) {
  Comparison comparison = two_branches();
  comparison.branches[0].report.after.metrics.set("cache", "hits", ratio(3, 4, false));
  comparison.branches[1].report.after.metrics.set("cache", "hits", ratio(1, 4, false));
  comparison.fronts = {{"time", "cache.hits"}};
  EXPECT_EQ(fronts_of(comparison)[0].branches, std::vector<std::size_t>{0});
}

TEST(Fronts, AreReadFromTwoNames) {
  Diagnostics diagnostics;
  EXPECT_EQ(parse_front("time,a.b", diagnostics), std::pair(std::string("time"), std::string("a.b")));
  EXPECT_EQ(parse_front("a.models.x, a.b", diagnostics), std::pair(std::string("a.models.x"), std::string("a.b")));
  EXPECT_TRUE(diagnostics.empty());
  for (const char* text : {"", ",", "time", "time,", "time, ", ",a.b", "a,b"}) {
    EXPECT_FALSE(parse_front(text, diagnostics)) << text;
  }
  EXPECT_THAT(to_text(diagnostics.all()[2]),
              HasSubstr("--front: error: expected two figures, found 'time'\n    hint: such as time,"));
}

TEST(SumOf, AddsFractionsAndTimesOverWholeFiles) {
  EXPECT_FALSE(sum_of(std::vector{two_branches()}));
  Comparison other = two_branches();
  other.branches[0].report.after.metrics.set("cache", "acmr", ratio(8, 3));
  const Comparison lost_file{{"gone.glb", 0}, {}, {}, {}};
  const auto sum = sum_of(std::vector{two_branches(), lost_file, other});
  ASSERT_TRUE(sum);
  EXPECT_EQ(sum->input.path, "all 2 files");
  EXPECT_EQ(value_of(sum->branches[0], "cache.acmr"), 2.5);  // (2 + 8) / (1 + 3)
  EXPECT_EQ(value_of(sum->branches[1], "time"), 2.0);
  Comparison partly = other;
  partly.branches[0].is_lost = true;
  const auto without_the_first = sum_of(std::vector{two_branches(), partly});
  EXPECT_TRUE(without_the_first->branches[0].is_lost);
  EXPECT_EQ(value_of(without_the_first->branches[1], "cache.acmr"), 1);
  EXPECT_THAT(to_text({two_branches(), lost_file}), HasSubstr("gone.glb\n  could not be read\n"));
  EXPECT_EQ(json::parse(to_json(std::vector{lost_file}))["files"][0]["lost"], true);
  EXPECT_THAT(to_text({two_branches(), other}), HasSubstr("\nall 2 files\n  [1] A\n"));
  const json all = json::parse(to_json(std::vector{two_branches(), other}))["all"];
  EXPECT_EQ(all["metrics"][0]["values"], json::parse("[2.5, 1.0]"));
}

TEST(ComparisonCsv, HasALineForEveryFigure) {
  Comparison comparison = two_branches();
  comparison.input.path = "a, \"b\".glb";
  comparison.branches.resize(1);
  Report& report = comparison.branches[0].report;
  report.draws.resize(1);
  report.draws[0].name = "rock";
  report.draws[0].after.metrics.set("cache", "acmr", ratio(1, 8));
  report.stages.resize(1);
  report.stages[0].memory = 4096;
  EXPECT_EQ(to_csv({comparison}),
            "file,branch,pipeline,draw,name,evaluator,metric,value,unit,error\r\n"
            "\"a, \"\"b\"\".glb\",input,,,,cache,acmr,3,per triangle,0\r\n"
            "\"a, \"\"b\"\".glb\",[1],A,,,cache,acmr,2,per triangle,0\r\n"
            "\"a, \"\"b\"\".glb\",[1],A,0,rock,cache,acmr,0.125,per triangle,0\r\n"
            "\"a, \"\"b\"\".glb\",[1],A,,,time,all stages,0.25,s,\r\n"
            "\"a, \"\"b\"\".glb\",[1],A,,,time,tipsify,0.25,s,\r\n"
            "\"a, \"\"b\"\".glb\",[1],A,,,memory,tipsify,4096,bytes,\r\n");
  EXPECT_THAT(to_csv({two_branches(), two_branches()}), HasSubstr("\r\nall 2 files,[1],A,,,cache,acmr,2,"));
}

TEST(ComparisonJson, NothingComparedIsNoFiles) {
  EXPECT_EQ(json::parse(to_json(std::vector<Comparison>{}))["files"], json::array());
}

}  // namespace
}  // namespace foredraw::comparison_test
