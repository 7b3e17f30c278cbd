#include <foredraw/pipeline/sweep.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::sweep_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> values(const std::string& text) {
  Diagnostics diagnostics;
  const auto sweep = parse_sweep("stage.option=" + text, diagnostics);
  EXPECT_TRUE(sweep) << to_text(diagnostics);
  return sweep ? sweep->values : std::vector<std::string>{};
}

std::string refused_sweep(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_sweep(text, diagnostics)) << text;
  return to_text(diagnostics);
}

TEST(ParseSweep, StepsFromTheFirstToTheLast) {
  EXPECT_THAT(values("1:1.5:0.1"), ElementsAre("1", "1.1", "1.2", "1.3", "1.4", "1.5"));
  EXPECT_THAT(values("8:32:8"), ElementsAre("8", "16", "24", "32"));
  EXPECT_THAT(values("3:1:-1"), ElementsAre("3", "2", "1"));
  EXPECT_THAT(values("0:1:0.4"), ElementsAre("0", "0.4", "0.8"));
  EXPECT_THAT(values("2:2:1"), ElementsAre("2"));
}

TEST(ParseSweep, OrTakesThemOneByOne) {
  EXPECT_THAT(values("fast,high"), ElementsAre("fast", "high"));
  EXPECT_THAT(values("true"), ElementsAre("true"));
  EXPECT_THAT(values("\"a, b\",c"), ElementsAre("\"a, b\"", "c"));
}

TEST(ParseSweep, SaysWhatItIsNot) {
  EXPECT_THAT(refused_sweep("growth"), HasSubstr("--sweep:1:1: error: expected stage.option=values, found 'growth'"));
  EXPECT_THAT(refused_sweep("=1:2:1"), HasSubstr("expected stage.option=values"));
  EXPECT_THAT(refused_sweep("a.b="), HasSubstr("a value is empty"));
  EXPECT_THAT(refused_sweep("a.b=1,,2"), HasSubstr("a value is empty"));
  EXPECT_THAT(refused_sweep("a.b=1:2"),
              HasSubstr("--sweep:1:5: error: expected FIRST:LAST:STEP, three numbers, found '1:2'"));
  EXPECT_THAT(refused_sweep("a.b=1:x:1"), HasSubstr("three numbers"));
  EXPECT_THAT(refused_sweep("a.b=1:inf:1"), HasSubstr("three numbers"));
  EXPECT_THAT(refused_sweep("a.b=1:2:0"), HasSubstr("steps of 0 do not lead from 1 to 2"));
  EXPECT_THAT(refused_sweep("a.b=1:2:-1"), HasSubstr("steps of -1 do not lead from 1 to 2"));
  EXPECT_THAT(refused_sweep("a.b=0:1e300:1e-300"), HasSubstr("more than 1000 values"));
}

class Swept : public ::testing::Test {
 protected:
  std::vector<NamedPipeline> pipelines(const std::vector<std::string>& lines) {
    std::vector<NamedPipeline> made;
    for (const std::string& line : lines) made.push_back({line, parse_line(line, diagnostics_).value()});
    return made;
  }

  std::vector<std::string> names(const std::vector<std::string>& lines, const std::vector<std::string>& sweeps) {
    std::vector<Sweep> parsed;
    for (const std::string& text : sweeps) parsed.push_back(parse_sweep(text, diagnostics_).value());
    made_ = swept(pipelines(lines), parsed, diagnostics_);
    std::vector<std::string> names;
    for (const NamedPipeline& named : made_.value_or(std::vector<NamedPipeline>{})) names.push_back(named.name);
    return names;
  }

  Diagnostics diagnostics_;
  std::optional<std::vector<NamedPipeline>> made_;
};

TEST_F(Swept, EveryCombinationWhereThereIsTheStage) {
  EXPECT_THAT(names({"tipsify, dot-rule", "weld"}, {"tipsify.cache-size=16,24", "dot-rule.x=1:2:1"}),
              ElementsAre("tipsify, dot-rule with tipsify.cache-size=16, dot-rule.x=1",
                          "tipsify, dot-rule with tipsify.cache-size=16, dot-rule.x=2",
                          "tipsify, dot-rule with tipsify.cache-size=24, dot-rule.x=1",
                          "tipsify, dot-rule with tipsify.cache-size=24, dot-rule.x=2", "weld"));
  EXPECT_EQ((*made_)[3].pipeline.stages[0].settings.at("cache-size"), OptionValue(std::int64_t{24}));
  EXPECT_EQ((*made_)[3].pipeline.stages[1].settings.at("x"), OptionValue(std::int64_t{2}));
}

TEST_F(Swept, NamesOfPipelinesStayWhatTheyAre) {
  EXPECT_THAT(names({"weld"}, {}), ElementsAre("weld"));
  EXPECT_THAT(names({"weld"}, {"seed=1:2:1"}), ElementsAre("weld with seed=1", "weld with seed=2"));
}

TEST_F(Swept, SaysWhereThereIsNoSuchStage) {
  EXPECT_THAT(names({"weld"}, {"tipsify.cache-size=16,24"}), ElementsAre());
  EXPECT_THAT(to_text(diagnostics_), HasSubstr("--sweep:1:1: error: the pipeline has no stage 'tipsify'"));
}

TEST_F(Swept, NamesTheNearestStageOfAnyPipeline) {
  EXPECT_THAT(names({"tipsify", "weld"}, {"tipsfy.cache-size=16,24"}), ElementsAre());
  EXPECT_THAT(to_text(diagnostics_), HasSubstr("did you mean 'tipsify'?"));
}

TEST_F(Swept, LeavesAloneWhatAllAreMeasuredWith) {
  std::vector<NamedPipeline> measured = pipelines({"tipsify"});
  measured[0].pipeline.measure = *parse_stages("overdraw-raster(count=10)", "--with", diagnostics_);
  const Sweep views = parse_sweep("overdraw-raster.count=10,400", diagnostics_).value();
  EXPECT_FALSE(swept(measured, {&views, 1}, diagnostics_));
  EXPECT_THAT(to_text(diagnostics_), HasSubstr("--sweep:1:1: error: 'overdraw-raster.count' belongs to an evaluator, "
                                               "but all pipelines are measured alike\n    hint: use --set"));
}

TEST_F(Swept, AnOptionOnce) {
  EXPECT_THAT(names({"tipsify"}, {"tipsify.cache-size=16,24", "tipsify.cache-size=8"}), ElementsAre());
  EXPECT_THAT(to_text(diagnostics_), HasSubstr("'tipsify.cache-size' is swept twice"));
}

TEST_F(Swept, MistakesAreToldWhereTheyStand) {
  EXPECT_THAT(names({"tipsify"}, {"tipsify.cache-size=16"}), ElementsAre("tipsify with tipsify.cache-size=16"));
  EXPECT_EQ((*made_)[0].pipeline.stages[0].option_where.at("cache-size").file, "--sweep");
}

TEST_F(Swept, KnowsWhenItIsTooMuch) {
  EXPECT_THAT(names({"weld"}, {"seed=1:40:1", "views.count=1:40:1"}), ElementsAre());
  EXPECT_THAT(to_text(diagnostics_), HasSubstr("there would be 1600 pipelines, more than 1000"));
}

}  // namespace
}  // namespace foredraw::sweep_test
