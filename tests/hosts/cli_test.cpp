// The program as its users run it: what it measures and tells.

#include "support/on_corpus.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace foredraw::cli_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::content;
using testing::Ended;

class Cli : public testing::OnCorpus {};

double metric(const Json& state, const char* plugin, const char* name) {
  return state["metrics"][plugin][name]["value"];
}

TEST_F(Cli, OptimizesAndMeasuresTheGain) {
  const Ended made = run("optimize " + spot() + " -o out.glb --report r.json");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(made.out.empty());
  EXPECT_NE(made.err.find("acmr"), std::string::npos);
  const Json report = Json::parse(content(folder_ / "r.json"));
  EXPECT_EQ(report["report"], 1);
  const Json& totals = report["totals"];
  EXPECT_LT(metric(totals, "vertex-cache", "acmr"), 0.75 * metric(totals["before"], "vertex-cache", "acmr"));
  EXPECT_LT(metric(totals, "overdraw-raster", "ratio"), metric(totals["before"], "overdraw-raster", "ratio"));
  EXPECT_EQ(totals["metrics"]["vertex-cache"]["acmr"]["unit"], "misses per triangle");
  EXPECT_GT(totals["metrics"]["overdraw-raster"]["ratio"]["error"].get<double>(), 0);
  EXPECT_TRUE(totals["metrics"]["vertex-cache"]["models"].contains("fifo-32"));
  EXPECT_EQ(report["evaluators"]["vertex-cache"]["options"]["cache-size"], 16);

  const Ended measured = run("measure out.glb --json");
  ASSERT_EQ(measured.code, 0) << measured.err;
  const Json again = Json::parse(measured.out);
  EXPECT_EQ(metric(again["totals"], "vertex-cache", "acmr"), metric(totals, "vertex-cache", "acmr"));
  EXPECT_EQ(metric(again["totals"], "overdraw-raster", "ratio"), metric(totals, "overdraw-raster", "ratio"));
  EXPECT_EQ(again["draws"].size(), 1u);
}

TEST_F(Cli, MeasuresWhatTheStagesAreAbout) {
  const std::string sprite = model("particles/kenney_smoke_04.png");
  const Ended trimmed = run("optimize " + sprite + " -o out.glb -p particle-trim --json");
  ASSERT_EQ(trimmed.code, 0) << trimmed.err;
  const Json before = Json::parse(trimmed.out)["totals"]["before"]["metrics"];
  EXPECT_TRUE(before.contains("sprite-fill"));
  EXPECT_FALSE(before.contains("vertex-cache")) << "two triangles more are no gain for it";
  const Ended packed = run("optimize " + spot() + " -o out.glb -p gpu-instances --json");
  EXPECT_TRUE(Json::parse(packed.out)["totals"]["before"]["metrics"].contains("scene-cost"));
  const Ended asked = run("optimize " + sprite + " -o out.glb -p particle-trim --with vertex-cache --json");
  EXPECT_FALSE(Json::parse(asked.out)["totals"]["before"]["metrics"].contains("sprite-fill"));
}

TEST_F(Cli, TellsThePlanWithoutRunningIt) {
  const Ended plan = run("plan " + model("static/flight_helmet_notex.glb"));
  EXPECT_EQ(plan.code, 0);
  EXPECT_NE(plan.out.find("alpha-blended"), std::string::npos) << plan.out;
  EXPECT_EQ(Json::parse(run("plan " + spot() + " --json").out)["stages"].size(), 6u);
  EXPECT_TRUE(files().empty());
}

TEST_F(Cli, ShowsWhatThereIs) {
  EXPECT_NE(run("list").out.find("tipsify"), std::string::npos);
  EXPECT_EQ(run("list --kind evaluator").out.find("tipsify"), std::string::npos);
  EXPECT_NE(run("show tipsify").out.find("cache-size"), std::string::npos);
  EXPECT_EQ(Json::parse(run("show tipsify --json").out)["options"][0]["default"], 16);
  EXPECT_NE(run("show @default").out.find("stages"), std::string::npos);
  EXPECT_TRUE(Json::parse(run("schema").out).contains("$schema"));
  EXPECT_NE(run("inspect " + model("animated/fox.glb")).out.find("576"), std::string::npos);
  EXPECT_EQ(Json::parse(run("inspect --json " + model("animated/fox.glb")).out)["animations"].size(), 3u);
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_NE(run("--version").out.find("foredraw"), std::string::npos);
}

/// The reference pages in docs/ are what the program says of itself. FOREDRAW_UPDATE_GOLDEN=1 writes them anew.
TEST_F(Cli, ItsReferencePagesAreTheCommittedOnes) {
  const Json list = Json::parse(run("list --json").out);
  std::vector<std::string> expected;
  for (const Json& plugin : list["plugins"]) {
    const std::string name = plugin["name"];
    const fs::path page = testing::project_file("docs/reference/plugins/" + name + ".md");
    const std::string text = run("show " + name).out;
    if (std::getenv("FOREDRAW_UPDATE_GOLDEN") != nullptr) std::ofstream(page) << text;
    EXPECT_EQ(content(page), text) << name << ": FOREDRAW_UPDATE_GOLDEN=1 writes the page anew";
    expected.push_back(name + ".md");
  }
  std::vector<std::string> there;
  for (const auto& entry : fs::directory_iterator(testing::project_file("docs/reference/plugins")))
    if (entry.path().filename() != "README.md") there.push_back(entry.path().filename().string());
  // A page may be there of a plugin that this build leaves out.
  const Json left_out = list.value("left-out", Json::object());
  for (const std::string& page : there) {
    const bool is_left_out = left_out.contains(page.substr(0, page.size() - 3));
    EXPECT_TRUE(is_left_out || std::find(expected.begin(), expected.end(), page) != expected.end()) << page;
  }
}

TEST_F(Cli, SaysWhyAPluginIsLeftOut) {
  const Json list = Json::parse(run("list --json").out);
  const std::string text = run("list").out;
  const Json left_out = list.value("left-out", Json::object());
  for (const auto& [name, reason] : left_out.items()) {
    EXPECT_NE(text.find("This build leaves out " + name + ": " + reason.get<std::string>()), std::string::npos);
    const Ended shown = run("show " + name);
    EXPECT_EQ(shown.code, 1);
    EXPECT_NE(shown.err.find(reason.get<std::string>()), std::string::npos) << shown.err;
  }
}

}  // namespace
}  // namespace foredraw::cli_test
