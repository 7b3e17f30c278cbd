#include <foredraw/report/report.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace foredraw::report_json_test {
namespace {

using Json = nlohmann::ordered_json;

/// Two draws, of which one has names and figures that JSON writes in its own way.
Report odd_report() {
  Report report;
  report.command = "optimize";
  report.input = {"a \"b\"\\c\n\xC3\xA4.glb", 12};
  report.optimized = true;
  report.seconds = 1e-7;
  report.draws.resize(2);
  DrawRecord& draw = report.draws[0];
  draw.name = "tab\there, no UTF-8: \xFF";
  draw.traits = {"welded", "triangles"};
  draw.after.triangles = 7;
  draw.after.metrics.set("one", "acmr", {1, 3.0, 0, "misses", true, false});
  draw.after.metrics.set("one", "acmr.part", {5, std::nullopt, 0.5, "", true, false});
  draw.after.metrics.set("one", "poses.Walk@0.1.ratio", {1e21, 1.0, 0, "", true, false});
  draw.after.metrics.set("one", "poses.Walk@0.5.x.ratio", {2, 1.0, 0, "", true, false});
  draw.after.metrics.set("one", "poses.Walk@0.ratio", {-0.0, std::nullopt, NAN, "", true, false});
  draw.after.metrics.set("two", "count", {1, 0.0, 0, "", true, false});
  report.stages.emplace_back().skipped.push_back({"code", "reason", {"a", "b"}});
  return report;
}

TEST(ReportJson, IsLaidOutAsTheLibraryDoes) {
  const std::string text = to_json(odd_report());
  EXPECT_EQ(text, Json::parse(text).dump(2) + '\n');
}

TEST(ReportJson, GroupsAreObjectsThatStandOnce) {
  const Json json = Json::parse(to_json(odd_report()));
  const Json& one = json["draws"][0]["metrics"]["one"];
  EXPECT_EQ(one["acmr"]["numerator"], 1.0);
  EXPECT_EQ(one["acmr"]["part"]["value"], 5.0);
  EXPECT_EQ(one["poses"].size(), 3u);
  EXPECT_EQ(one["poses"]["Walk@0.1"]["ratio"]["value"], 1e21);
  EXPECT_TRUE(one["poses"]["Walk@0"]["ratio"]["error"].is_null());
  EXPECT_TRUE(json["draws"][0]["metrics"]["two"]["count"]["value"].is_null());
  EXPECT_EQ(json["draws"][1]["before"]["metrics"], Json::object());
  EXPECT_EQ(json["draws"][0]["traits"], Json({"triangles", "welded"}));
}

TEST(ReportJson, OfManyDrawsComesInPieces) {
  Report report = odd_report();
  report.draws.assign(2000, report.draws[0]);
  std::string whole;
  std::size_t longest = 0;
  write_json(report, [&](std::string_view piece) {
    longest = std::max(longest, piece.size());
    whole += piece;
  });
  EXPECT_EQ(whole, to_json(report));
  EXPECT_LT(10 * longest, whole.size());
}

}  // namespace
}  // namespace foredraw::report_json_test
