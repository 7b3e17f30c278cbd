// Films and charts in the record of a run.
#include <foredraw/report/comparison.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace foredraw::attachments_test {
namespace {

using Json = nlohmann::ordered_json;

AttachmentRecord film(const std::string& about, std::size_t frames) {
  Film film{"levels", "the lighter, the finer", 2, 1, {}};
  for (std::size_t i = 0; i < frames; ++i) film.frames.push_back({1, 1, 1, 2, 2, 2});
  return {about, std::make_shared<const Attachment>(std::move(film))};
}

AttachmentRecord chart() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Chart chart{"time", "of the cost model", "frame", "time of a frame", "ms", {}, {{"budget", 10}}};
  chart.lines = {{"a", {1.5, std::nan(""), infinity}}, {"b \"c\"", {4, -5, 1e21}}};
  return {"", std::make_shared<const Attachment>(std::move(chart))};
}

Report report_with_all() {
  Report report;
  report.optimized = true;
  StageRecord& measure = report.measures.emplace_back();
  measure.use = "walk";
  measure.attachments = {chart(), film("A", 3)};
  measure.attachments_before = {film("A", 2)};
  report.measures.emplace_back().use = "other";
  report.stages.emplace_back().attachments = {film("", 1)};
  return report;
}

TEST(Attachments, ChartsAreWholeAndFilmsAreTold) {
  const Json json = Json::parse(to_json(report_with_all()));
  const Json& walk = json["measures"][0];
  EXPECT_EQ(walk["attachments"][0], Json::parse(R"({
      "kind": "chart", "place": "", "name": "time", "caption": "of the cost model",
      "x": "frame", "y": "time of a frame", "unit": "ms", "mark": {"name": "budget", "value": 10.0},
      "lines": [{"name": "a", "values": [1.5, null, null]}, {"name": "b \"c\"", "values": [4.0, -5.0, 1e21]}]})"));
  const Json told = Json::parse(R"({"kind": "film", "place": "A", "name": "levels", "caption": "the lighter, the finer",
                                    "width": 2, "height": 1, "frames": 3})");
  EXPECT_EQ(walk["attachments"][1], told);
  EXPECT_EQ(walk["before"]["attachments"][0]["frames"], 2);
  EXPECT_EQ(json["stages"][0]["attachments"].size(), 1u);
  EXPECT_FALSE(json["stages"][0].contains("before"));
}

TEST(Attachments, AreNotMentionedWhereThereAreNone) {
  const Json json = Json::parse(to_json(report_with_all()));
  EXPECT_FALSE(json["measures"][1].contains("attachments"));
  EXPECT_FALSE(json["measures"][1].contains("before"));
}

TEST(Attachments, AMarkIsToldWhereThereIsOne) {
  Chart bare{"n", "", "frame", "", "", {{"a", {1}}}, {}};
  Report report;
  report.measures.emplace_back().attachments = {{"", std::make_shared<const Attachment>(bare)}};
  const Json json = Json::parse(to_json(report));
  EXPECT_FALSE(json["measures"][0]["attachments"][0].contains("mark"));
}

TEST(Attachments, WithoutTheirPicturesAreToldAlike) {
  Report report = report_with_all();
  const std::string whole = to_json(report);
  const auto kept = report.measures[0].attachments[1].content;
  leave_out_pictures(report);
  EXPECT_EQ(to_json(report), whole);
  for (const auto* attachments : {&report.measures[0].attachments_before, &report.stages[0].attachments}) {
    for (const auto& frame : std::get<Film>(*attachments->front().content).frames) EXPECT_TRUE(frame.empty());
  }
  EXPECT_TRUE(std::get<Film>(*report.measures[0].attachments[1].content).frames[2].empty());
  EXPECT_EQ(std::get<Film>(*kept).frames[2].size(), 6u);  // who else holds it keeps it
}

/// Sums are of figures: a film of several files is none.
TEST(Attachments, AreOfNoSumOfFiles) {
  Comparison comparison{{"a.glb", 1}, {{"pipeline", report_with_all()}}, {}};
  const Json json = Json::parse(to_json(std::vector<Comparison>{comparison, comparison}));
  EXPECT_TRUE(json["files"][1]["branches"][0]["report"]["measures"][0].contains("attachments"));
  EXPECT_EQ(json["all"]["branches"][0]["report"].dump().find("attachments"), std::string::npos);
}

}  // namespace
}  // namespace foredraw::attachments_test
