#include <foredraw/report/bound.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::bound_test {
namespace {

std::optional<Bound> parsed(const std::string& text) {
  Diagnostics diagnostics;
  const auto bound = parse_bound(text, diagnostics);
  EXPECT_EQ(bound.has_value(), diagnostics.empty()) << to_text(diagnostics);
  return bound;
}

Branch branch(std::string name, double acmr, double seconds = 1) {
  Branch branch{std::move(name), {}};
  branch.report.optimized = true;
  branch.report.before.metrics.set("vertex-cache", "acmr", {2, 1, 0, "", true});
  branch.report.after.metrics.set("vertex-cache", "acmr", {acmr, 1, 0, "", true});
  branch.report.after.metrics.set("vertex-cache", "models.amd.acmr", {3 * acmr, 1, 0, "", true});
  StageRecord stage;
  stage.seconds = seconds;
  branch.report.stages = {stage};
  return branch;
}

const std::vector<Comparison> two = {{{"a/rock.glb", 1}, {branch("old", 1), branch("new", 1.2, 4)}}};

/// The codes of what is told, and the texts.
std::string told(const std::string& text, const Baseline::Files* stored = nullptr) {
  Diagnostics diagnostics;
  const Bound bound = parsed(text).value();
  const Baseline baseline(stored == nullptr ? Baseline::Files() : *stored);
  judge({&bound, 1}, two, stored == nullptr ? nullptr : &baseline, diagnostics);
  std::string codes;
  for (const Diagnostic& diagnostic : diagnostics.all()) codes += diagnostic.code + ": " + diagnostic.message + '\n';
  return codes;
}

TEST(Bound, IsAFigureBesideALimit) {
  const Bound bound = parsed("vertex-cache.models.fifo-32.acmr>=baseline*1.5 - 0.25").value();
  EXPECT_EQ(bound.figure, "vertex-cache.models.fifo-32.acmr");
  EXPECT_EQ(bound.than, Bound::Than::from);
  EXPECT_EQ(bound.beside, Bound::Beside::baseline);
  EXPECT_EQ(bound.factor, 1.5);
  EXPECT_EQ(bound.added, -0.25);
  EXPECT_EQ(parsed("  time  <  0.5  ")->beside, Bound::Beside::nothing);
  EXPECT_EQ(parsed("time < -1e3")->added, -1000);
  EXPECT_EQ(parsed("x.y <= input + 2")->added, 2);
  EXPECT_EQ(parsed("x.y <= input + 2")->factor, 1);
}

TEST(Bound, WhatIsNoneIsToldWithItsPlace) {
  for (const auto& [text, expected] :
       std::map<std::string, std::string>{{"", "expected EVALUATOR.METRIC or time at ''"},
                                          {"acmr > 1", "expected EVALUATOR.METRIC or time at ' > 1'"},
                                          {"x.y = 1", "expected one of > >= < <= at '= 1'"},
                                          {"x.y >", "expected a number, baseline or input at ''"},
                                          {"x.y > basline", "expected a number, baseline or input at 'basline'"},
                                          {"x.y > baseline *", "expected a number at ''"},
                                          {"x.y > baseline * inf", "expected a number at 'inf'"},
                                          {"x.y > nan", "expected a number, baseline or input at 'nan'"},
                                          {"x.y > 1 2", "expected its end at '2'"}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_bound(text, diagnostics)) << text;
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_NE(diagnostics.all()[0].message.find(expected), std::string::npos) << diagnostics.all()[0].message;
  }
}

TEST(Judge, TellsOfEachBranchThatIsOut) {
  EXPECT_EQ(told("vertex-cache.acmr > 1.2"), "");
  EXPECT_EQ(told("vertex-cache.acmr >= 1.2"),
            "out-of-bounds: vertex-cache.acmr is 1.2 after [2] new; the bound is 1.2: vertex-cache.acmr >= 1.2\n");
  EXPECT_EQ(told("vertex-cache.acmr < 1.1"),
            "out-of-bounds: vertex-cache.acmr is 1 after [1] old; the bound is 1.1: vertex-cache.acmr < 1.1\n");
  EXPECT_EQ(told("vertex-cache.models.amd.acmr > 3"),
            "out-of-bounds: vertex-cache.models.amd.acmr is 3.6 after [2] new; the bound is 3: "
            "vertex-cache.models.amd.acmr > 3\n");
  EXPECT_EQ(told("time > 3"), "out-of-bounds: time is 4 after [2] new; the bound is 3: time > 3\n");
}

TEST(Judge, BesideTheInputAndTheFirstPipeline) {
  EXPECT_EQ(told("vertex-cache.acmr > input * 0.6"), "");
  EXPECT_EQ(
      told("vertex-cache.acmr > input * 0.55"),
      "out-of-bounds: vertex-cache.acmr is 1.2 after [2] new; the bound is 1.1: vertex-cache.acmr > input * 0.55\n");
  EXPECT_EQ(told("vertex-cache.acmr > baseline + 0.2"), "");
  EXPECT_EQ(
      told("vertex-cache.acmr > baseline * 1.1"),
      "out-of-bounds: vertex-cache.acmr is 1.2 after [2] new; the bound is 1.1: vertex-cache.acmr > baseline * 1.1\n");
  EXPECT_EQ(told("vertex-cache.acmr <= baseline"), "");  // the baseline is not judged beside itself
}

TEST(Judge, BesideStoredFigures) {
  Baseline::Files stored = {{"elsewhere/rock.glb", {{"vertex-cache.acmr", 0.5}}}};
  EXPECT_NE(told("vertex-cache.acmr > baseline", &stored).find("1 after [1] old; the bound is 0.5"), std::string::npos);
  stored["a/rock.glb"] = {{"vertex-cache.acmr", 1.1}};  // nearer than one of that name
  EXPECT_EQ(told("vertex-cache.acmr > baseline", &stored),
            "out-of-bounds: vertex-cache.acmr is 1.2 after [2] new; the bound is 1.1: vertex-cache.acmr > baseline\n");
  stored = {{"other.glb", {{"vertex-cache.acmr", 1}}}};
  EXPECT_NE(told("vertex-cache.acmr > baseline", &stored)
                .find("unknown-baseline: 'vertex-cache.acmr > baseline' cannot be checked: the stored baseline does "
                      "not have this file"),
            std::string::npos);
}

TEST(Judge, BesideTheSameFileHoweverItsPathIsWritten) {
  Baseline::Files stored = {{"./a/../a/rock.glb", {{"vertex-cache.acmr", 0.5}}},
                            {"b/rock.glb", {{"vertex-cache.acmr", 9}}}};
  EXPECT_NE(told("vertex-cache.acmr > baseline", &stored).find("the bound is 0.5"), std::string::npos);
  stored = {{"b/rock.glb", {{"vertex-cache.acmr", 9}}}, {"c/rock.glb", {{"vertex-cache.acmr", 0.5}}}};  // which?
  EXPECT_NE(told("vertex-cache.acmr > baseline", &stored).find("unknown-baseline"), std::string::npos);
}

TEST(Judge, WhatNobodyMeasuredIsNotPassed) {
  EXPECT_NE(told("vertex-cache.acm > 1").find("unknown-figure"), std::string::npos);
  EXPECT_NE(told("overdraw-raster.ratio > baseline").find("the first pipeline has no figure"), std::string::npos);
  EXPECT_NE(told("time > input").find("the input has no figure"), std::string::npos);
}

Baseline::Files stored(const std::string& text) {
  Diagnostics diagnostics;
  const auto baseline = read_baseline(text, "r.json", diagnostics);
  EXPECT_TRUE(baseline) << to_text(diagnostics);
  return baseline ? baseline->files() : Baseline::Files();
}

TEST(StoredFigures, AreReadOutOfEveryForm) {
  Report report = two[0].branches[1].report;
  report.input.path = "a/rock.glb";
  const StoredFigures expected = {{"vertex-cache.acmr", 1.2}, {"vertex-cache.models.amd.acmr", 3 * 1.2}, {"time", 4}};
  EXPECT_EQ(stored(to_json(report)).at("a/rock.glb"), expected);
  std::vector<Comparison> comparisons = two;
  comparisons[0].branches[0].report = report;
  EXPECT_EQ(stored(to_json(comparisons)).at("a/rock.glb"), expected);
  EXPECT_EQ(stored(R"({"batch": 1, "files": [{"outcome": "lost", "report": {}},
                      {"outcome": "done", "report": )" +
                   to_json(report) + "}]}")
                .at("a/rock.glb"),
            expected);
}

TEST(StoredFigures, WhatCanNotBeReadIsRefused) {
  for (const auto& [text, expected] : std::map<std::string, std::string>{
           {"", "is not a JSON object"},
           {"[1]", "is not a JSON object"},
           {"{}", "is not a report, a batch or a comparison"},
           {R"({"report": "1"})", "is not a report"},
           {R"({"report": 7})", "is a report of version 7, but this program reads versions up to 1"},
           {R"({"report": 1})", "an incomplete report"},
           {R"({"comparison": 1, "files": [{"branches": []}]})", "an incomplete comparison"},
           {R"({"batch": 1, "files": 3})", "an incomplete batch"}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_baseline(text, "r.json", diagnostics)) << text;
    ASSERT_EQ(diagnostics.all().size(), 1u) << text;
    EXPECT_EQ(diagnostics.all()[0].where.file, "r.json");
    EXPECT_NE(diagnostics.all()[0].message.find(expected), std::string::npos) << diagnostics.all()[0].message;
  }
}

}  // namespace
}  // namespace foredraw::bound_test
