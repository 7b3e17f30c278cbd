#include <foredraw/report/batch.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw {
namespace {

using ::testing::HasSubstr;

BatchFile file(const std::string& path, double misses_before, double misses_after, Outcome outcome) {
  BatchFile file{{}, outcome};
  file.report.optimized = true;
  file.report.input = {path, 100};
  file.report.output = {"out/" + path, 90};
  file.report.before.metrics.set("cache", "acmr", {misses_before, 10, 0, "per triangle", true});
  file.report.after.metrics.set("cache", "acmr", {misses_after, 10, 0, "per triangle", true});
  file.report.after.triangles = 10;
  return file;
}

Batch three_files() {
  return {"optimize",
          {file("a.glb", 20, 10, Outcome::done), file("b.glb", 30, 20, Outcome::in_part),
           file("c.glb", 1000, 1000, Outcome::lost)},
          1.5};
}

TEST(Batch, TotalsAreSumsOfWhatWasNotLost) {
  const StateRecord after = totals(three_files(), &Report::after);
  EXPECT_EQ(after.triangles, 20u);
  EXPECT_DOUBLE_EQ(after.metrics.find("cache", "acmr")->value(), 1.5);
  EXPECT_DOUBLE_EQ(totals(three_files(), &Report::before).metrics.find("cache", "acmr")->value(), 2.5);
}

TEST(Batch, ALineForEachFileAndOneForAll) {
  const std::string text = to_text(three_files());
  EXPECT_THAT(text, HasSubstr("file   cache acmr        bytes"));
  EXPECT_THAT(text, HasSubstr("a.glb  2.0000 -> 1.0000  100 -> 90   done\n"));
  EXPECT_THAT(text, HasSubstr("b.glb  3.0000 -> 2.0000  100 -> 90   in part: a stage failed\n"));
  EXPECT_THAT(text, HasSubstr("c.glb" + std::string(32, ' ') + "failed: see above\n"));
  EXPECT_THAT(text, HasSubstr("all    2.5000 -> 1.5000  200 -> 180  without 1 failed file\n"));
}

TEST(Batch, TheRecordHoldsEveryReport) {
  const auto json = nlohmann::json::parse(to_json(three_files()));
  EXPECT_EQ(json["batch"], 1);
  EXPECT_EQ(json["files"].size(), 3u);
  EXPECT_EQ(json["files"][1]["outcome"], "in-part");
  EXPECT_EQ(json["files"][0]["report"]["input"]["path"], "a.glb");
  EXPECT_DOUBLE_EQ(json["totals"]["metrics"]["cache"]["acmr"]["value"], 1.5);
}

}  // namespace
}  // namespace foredraw
