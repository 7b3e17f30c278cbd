#include <foredraw/report/since.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace foredraw::since_test {
namespace {

Metrics metrics(double acmr, double atvr = 1, double triangles = 100) {
  Metrics metrics;
  metrics.set("vertex-cache", "acmr", {100 * acmr, 100, 0, "misses per triangle"});
  metrics.set("vertex-cache", "models.amd.acmr", {acmr, 1, 0, ""});
  metrics.set("overdraw", "ratio", {atvr, 1, 0.01, ""});
  Figure levels{triangles, std::nullopt, 0, ""};
  levels.lower_is_better = false;
  metrics.set("levels", "saved", levels);
  return metrics;
}

StoredFigures stored(double acmr, double ratio = 1, double saved = 100) {
  return {{"vertex-cache.acmr", acmr},
          {"vertex-cache.models.amd.acmr", 7},
          {"overdraw.ratio", ratio},
          {"levels.saved", saved},
          {"time", 1}};
}

std::vector<std::string> rows(const Since& since) {
  std::vector<std::string> rows;
  for (const Since::Change& change : since.changes()) {
    rows.push_back(change.file + ' ' + change.figure + ' ' + change.was + ' ' + change.now + ' ' + change.change);
  }
  return rows;
}

TEST(Since, TellsTheWorstFirst) {
  const Baseline baseline({{"a", stored(0.5)}, {"b", stored(0.5)}, {"c", stored(0.5, 1, 200)}, {"d", stored(0)}});
  Since since("last.json", baseline);
  since.add("a", metrics(0.4));
  since.add("b", metrics(0.6));
  since.add("c", metrics(0.5));
  since.add("d", metrics(0.1));
  EXPECT_EQ(rows(since),
            (std::vector<std::string>{"d vertex-cache acmr 0.0000 0.1000 ", "c levels saved 200 100 -50.0 %",
                                      "b vertex-cache acmr 0.5000 0.6000 +20.0 %",
                                      "a vertex-cache acmr 0.5000 0.4000 -20.0 %"}));
  const std::string text = since.to_text();
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "since last.json: 3 figures of 3 files are worse, 1 figure of 1 file is better; 0 files are the same");
  EXPECT_LT(text.find("\nd "), text.find("\nc "));
  EXPECT_EQ(text.find("\na "), std::string::npos) << "better ones are counted";
}

TEST(Since, WhatMayBeDueToErrorsOrIsSmallIsTheSame) {
  const Baseline baseline({{"a", stored(0.50001, 1.015)}});
  Since since("last.json", baseline);
  since.add("a", metrics(0.5));
  EXPECT_TRUE(since.changes().empty());
  EXPECT_EQ(since.to_text(), "since last.json: none is worse, none is better; 1 file is the same\n");
}

TEST(Since, TellsOfFilesThatCameWentAndFailed) {
  const Baseline baseline({{"a", stored(1)}, {"b", stored(1)}, {"c", stored(1)}});
  for (const bool is_part : {false, true}) {
    Since since("last.json", baseline, is_part);
    since.add("./a", metrics(1));
    since.add_lost("b");
    since.add("d", metrics(1));
    since.add_lost("e");  // which is new
    const auto json = nlohmann::json::parse(since.to_json());
    EXPECT_EQ(json["failed"], nlohmann::json::parse(R"(["b"])"));
    EXPECT_EQ(json["new"], nlohmann::json::parse(R"(["d"])"));
    EXPECT_EQ(json["gone"], nlohmann::json::parse(is_part ? "[]" : R"(["c"])"));
    EXPECT_EQ(json["same"], 1);
    EXPECT_NE(since.to_text().find("1 file failed that did not fail before:\n  b\n"), std::string::npos);
  }
}

TEST(Since, TablesForPeopleEnd) {
  Baseline::Files files;
  for (int i = 0; i < 100; ++i) files["f" + std::to_string(i)] = stored(1);
  const Baseline baseline(files);
  Since since("last.json", baseline);
  for (int i = 0; i < 100; ++i) since.add("f" + std::to_string(i), metrics(2 + i));
  EXPECT_EQ(since.changes().front().file, "f99");
  const std::string text = since.to_text();
  EXPECT_LT(std::ranges::count(text, '\n'), 30);
  EXPECT_NE(text.find("and 80 more"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(since.to_json())["changed"].size(), 100u);
}

}  // namespace
}  // namespace foredraw::since_test
