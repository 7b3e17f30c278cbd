#include <foredraw/report/report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::report_text_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Report optimized() {
  Report report;
  report.input = {"in.glb", 1234567};
  report.output = {"out.glb", 999};
  report.optimized = true;
  report.draws.resize(2);
  report.before = {1000, 3000, {}};
  report.after = {1000, 600, {}};
  report.before.metrics.set("cache", "acmr", {3, 1.0, 0, "misses per triangle"});
  report.after.metrics.set("cache", "acmr", {6, 8.0, 0, "misses per triangle"});
  StageRecord stage;
  stage.use = "tipsify";
  stage.text = "tipsify(cache-size=16)";
  stage.seconds = 0.0125;
  stage.changed = 1;
  stage.candidates = 2;
  stage.loops_over = "draws";
  report.stages = {stage};
  return report;
}

TEST(ReportText, BeforeAndAfter) {
  EXPECT_EQ(to_text(optimized()),
            "in.glb (1,234,567 bytes) -> out.glb (999 bytes)\n"
            "2 draws, 1,000 triangles, 600 vertices (before: 3,000)\n"
            "\n"
            "       metric  before  after   change   unit\n"
            "-----  ------  ------  ------  -------  -------------------\n"
            "cache  acmr    3.0000  0.7500  -75.0 %  misses per triangle\n"
            "\n"
            "stage                   changed       time\n"
            "----------------------  ------------  -------\n"
            "tipsify(cache-size=16)  1 of 2 draws  12.5 ms\n");
}

TEST(ReportText, OneColumnWhereNothingWasChanged) {
  Report report = optimized();
  report.optimized = false;
  report.output = {};
  report.stages.clear();
  EXPECT_EQ(to_text(report),
            "in.glb (1,234,567 bytes)\n"
            "2 draws, 1,000 triangles, 600 vertices\n"
            "\n"
            "       metric  value   unit\n"
            "-----  ------  ------  -------------------\n"
            "cache  acmr    0.7500  misses per triangle\n");
}

TEST(ReportText, FiguresAsTheyAre) {
  Report report = optimized();
  Metrics& before = report.before.metrics;
  Metrics& after = report.after.metrics;
  before.set("cache", "same", {2, 1.0});
  after.set("cache", "same", {2.0001, 1.0});
  after.set("cache", "count", {1234, std::nullopt, 0, "misses"});
  after.set("cache", "estimate", {1, 2.0, 0.01});
  before.set("cache", "gone", {1, 2.0});
  after.set("cache", "gone", {0, 0.0});
  after.set("cache", "models.amd.acmr", {1, 2.0});
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr("same      2.0000  2.0001          same\n"));
  EXPECT_THAT(text, HasSubstr("count     -       1,234 "));
  EXPECT_THAT(text, HasSubstr("estimate  -       0.5000 ±0.0100"));
  EXPECT_THAT(text, HasSubstr("gone      0.5000  -\n")) << "what can not be divided has no change either";
  EXPECT_THAT(text, Not(HasSubstr("models")));
}

TEST(ReportText, SkippedPlacesInOneLineAndTheRestCounted) {
  Report report = optimized();
  report.stages[0].skipped = {{"blended", "its order may show", {"A", "B", "C", "D", "E", "F"}},
                              {"unavailable", "no device", {}},
                              {"scene", "nothing to do", {""}}};
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr("  tipsify left A, B, C, D and 2 more alone: its order may show\n"));
  EXPECT_THAT(text, HasSubstr("  tipsify left all alone: no device\n"));
  EXPECT_THAT(text, HasSubstr("  tipsify left the scene alone: nothing to do\n"));
}

TEST(ReportText, ThreeReasonsOfAKindAndTheRestCounted) {
  Report report = optimized();
  for (int i = 1; i <= 5; ++i) {
    report.stages[0].skipped.push_back({"no-gain", "reason " + std::to_string(i), {"Rock" + std::to_string(i)}});
  }
  report.stages[0].skipped.push_back({"blended", "another kind", {"Glass"}});
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr("  tipsify left Rock3 alone: reason 3\n"));
  EXPECT_THAT(text, Not(HasSubstr("reason 4")));
  EXPECT_THAT(text, HasSubstr("  tipsify left 2 more alone (no-gain); --json lists them all\n"));
  EXPECT_THAT(text, HasSubstr("  tipsify left Glass alone: another kind\n"));
  EXPECT_THAT(text, Not(HasSubstr("(blended)")));
}

TEST(ReportText, NotesNameTheirPlace) {
  Report report = optimized();
  report.stages[0].notes = {{"Rock", "k", "was odd"}, {"", "k", "all well"}};
  StageRecord measure;
  measure.use = "overdraw-raster";
  measure.notes = {{"", "k", "the views are the same"}};
  report.measures = {measure};
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr("  tipsify on Rock: was odd\n  tipsify: all well\n"));
  EXPECT_THAT(text, HasSubstr("  overdraw-raster: the views are the same\n"));
}

TEST(ReportText, NotesThatSayTheSameAreOneLine) {
  Report report = optimized();
  report.stages[0].notes = {{"A", "blended", "not merged: it is blended"},
                            {"B", "other", "not merged: it is blended"},
                            {"C", "blended", "not merged: it is blended"}};
  for (const char* more : {"D", "E", "F"})
    report.stages[0].notes.push_back({more, "blended", "not merged: it is blended"});
  EXPECT_THAT(to_text(report), HasSubstr("  tipsify on A, C, D, E and 1 more: not merged: it is blended\n"
                                         "  tipsify on B: not merged: it is blended\n"));
}

/// As that of surfaces, which is measured against what was there before.
TEST(ReportText, AnErrorThatWasNoneIsNoLoss) {
  Report report = optimized();
  report.before.metrics.set("surface-error", "rms", {0, 0.02});
  report.after.metrics.set("surface-error", "rms", {0.1, 0.02});
  EXPECT_THAT(to_text(report), Not(HasSubstr("worse than before")));
}

TEST(ReportText, ARatioOfLessWorkIsNoLoss) {
  Report report = optimized();
  Metrics& before = report.before.metrics;
  Metrics& after = report.after.metrics;
  before.set("cache", "atvr", {1728, 1728.0});
  after.set("cache", "atvr", {456, 434.0});  // fewer vertices are shaded, and still fewer are there
  EXPECT_THAT(to_text(report), Not(HasSubstr("worse than before")));
  after.set("cache", "atvr", {1800, 1728.0});
  EXPECT_THAT(to_text(report), HasSubstr("worse than before: cache atvr ("));
  // The worst view may be another one than before, so that its fragments tell nothing.
  Figure worst{200, 100.0};
  worst.worst_stands = true;
  before.set("cache", "atvr", worst);
  worst = {90, 30.0};
  worst.worst_stands = true;
  after.set("cache", "atvr", worst);
  EXPECT_THAT(to_text(report), HasSubstr("worse than before: cache atvr ("));
  const auto higher_is_better = [](double numerator, double denominator) {
    return Figure{numerator, denominator, 0, "", false};
  };
  before.set("cache", "atvr", higher_is_better(10, 20));
  after.set("cache", "atvr", higher_is_better(9, 20));
  EXPECT_THAT(to_text(report), HasSubstr("worse than before: cache atvr ("));
  after.set("cache", "atvr", higher_is_better(12, 30));
  EXPECT_THAT(to_text(report), Not(HasSubstr("worse than before")));
}

TEST(ReportText, CountsOfWhatIsLeftOutAreNeitherBetterNorWorse) {
  Report report = optimized();
  Figure left_out{1, std::nullopt, 0, "draws"};
  left_out.is_neutral = true;
  report.before.metrics.set("cache", "left-out", left_out);
  left_out.numerator = 10;
  report.after.metrics.set("cache", "left-out", left_out);
  EXPECT_THAT(to_text(report), HasSubstr("left-out  1       10               draws\n"));
}

TEST(ReportText, OneThingIsSingular) {
  Report report = optimized();
  report.draws.resize(1);
  report.before = report.after = {1, 1, {}};
  EXPECT_THAT(to_text(report), HasSubstr("\n1 draw, 1 triangle, 1 vertex\n"));
}

TEST(ReportText, StagesOnTheWholeScene) {
  Report report = optimized();
  report.stages[0].loops_over = "scene";
  EXPECT_THAT(to_text(report), HasSubstr("tipsify(cache-size=16)  the scene  12.5 ms"));
  report.stages[0].changed = 0;
  report.stages[0].seconds = 2.5;
  EXPECT_THAT(to_text(report), HasSubstr("tipsify(cache-size=16)  nothing  2.50 s"));
}

TEST(ReportText, OddFactsAreSummedOverTheDraws) {
  Report report = optimized();
  EXPECT_THAT(to_text(report), Not(HasSubstr("unusual in the input")));
  report.draws[0].facts.zero_area = 1000;
  report.draws[1].facts.zero_area = 34;
  EXPECT_THAT(to_text(report), HasSubstr("\nunusual in the input, and kept: zero-area 1,034\n"));
}

}  // namespace
}  // namespace foredraw::report_text_test
