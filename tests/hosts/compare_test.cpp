// Several pipelines on the same scenes, as users of the program compare them.

#include "support/mistake.h"
#include "support/on_corpus.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace foredraw::compare_test {
namespace {

using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using testing::Mistake;
using ::testing::Not;
using testing::put;
using Json = nlohmann::json;

class Compare : public testing::OnCorpus {
 protected:
  /// What `compare` of spot says in JSON.
  Json compared(const std::string& arguments) {
    const Ended ended = run("compare " + spot() + " --with vertex-cache --json " + arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return Json::parse(ended.out)["files"][0];
  }
  static std::vector<std::string> names(const Json& file) {
    std::vector<std::string> names;
    for (const Json& branch : file["branches"]) names.push_back(branch["name"]);
    return names;
  }
};

double acmr(const Json& branch) { return branch["report"]["totals"]["metrics"]["vertex-cache"]["acmr"]["value"]; }

TEST_F(Compare, ComparesPipelines) {
  const Ended compared = run("compare " + spot() + " -p weld -p weld,tipsify --json");
  ASSERT_EQ(compared.code, 0) << compared.err;
  const Json json = Json::parse(compared.out);
  const Json& branches = json["files"][0]["branches"];
  ASSERT_EQ(branches.size(), 2u);
  EXPECT_GT(acmr(branches[0]), acmr(branches[1]));
  EXPECT_EQ(branches[1]["report"]["stages"][1]["use"], "tipsify");
  EXPECT_NE(run("compare " + spot() + " -p weld -p weld,tipsify").out.find("acmr"), std::string::npos);
}

TEST_F(Compare, HoldsFiguresToABudget) {
  const std::string both = "compare " + spot() + " -p tipsify -p weld,tipsify --with vertex-cache ";
  EXPECT_EQ(run(both + "--fail-if 'vertex-cache.acmr > baseline'").code, 0);
  const Ended out = run(both + "--repeat 3 --fail-if 'vertex-cache.acmr <= baseline' --fail-if 'time < 1e6'");
  EXPECT_EQ(out.code, 3);
  EXPECT_NE(out.err.find("vertex-cache.acmr <= baseline"), std::string::npos) << out.err;
  EXPECT_NE(out.err.find("time < 1e6"), std::string::npos) << out.err;
  EXPECT_NE(out.out.find("acmr"), std::string::npos);  // and the comparison is told all the same

  ASSERT_EQ(run("optimize " + spot() + " -o o.glb -p weld,tipsify --with vertex-cache --report r.json").code, 0);
  const std::string one = "compare " + spot() + " -p weld,tipsify --with vertex-cache --fail-if ";
  EXPECT_EQ(run(one + "'vertex-cache.acmr > baseline' --baseline r.json").code, 0);
  EXPECT_EQ(run(one + "'vertex-cache.acmr > baseline * 0.99' --baseline r.json").code, 3);
  EXPECT_EQ(run(one + "'vertex-cache.acm > 1'").code, 1);
}

TEST_F(Compare, ComparesTheGoodFilesThoughOneIsBad) {
  put(folder_ / "bad.glb", "glTF but not really");
  const Ended compared = run("compare " + spot() + " bad.glb -p weld --with vertex-cache");
  EXPECT_EQ(compared.code, 2);
  EXPECT_NE(compared.out.find("spot.glb"), std::string::npos);
  EXPECT_THAT(compared.out, HasSubstr("bad.glb\n  could not be read\n"));
  EXPECT_NE(compared.err.find("bad.glb: error"), std::string::npos);
}

TEST_F(Compare, SetsAnOptionWhereverThereIsItsStage) {
  EXPECT_EQ(run("compare " + spot() + " -p weld,tipsify -p weld --set tipsify.cache-size=24 --with vertex-cache").code,
            0);
  EXPECT_EQ(run("compare " + spot() + " -p weld -p weld --set tipsify.cache-size=24 --with vertex-cache").code, 1);
}

TEST_F(Compare, RowsOfAFileGoOnFromItsStages) {
  put(folder_ / "p.toml",
      "pipeline = 1\nstages = ['weld', 'lookahead']\n[compare]\nsorted = ['linear-clusters', 'dot-rule']\nplain = "
      "[]\n");
  const Json file = compared("-p p.toml -p weld");
  EXPECT_EQ(names(file), (std::vector<std::string>{"p.toml: sorted", "p.toml: plain", "weld"}));
  const Json& sorted = file["branches"][0]["report"]["stages"];
  const Json& plain = file["branches"][1]["report"]["stages"];
  ASSERT_EQ(sorted.size(), 4u);
  ASSERT_EQ(plain.size(), 2u);
  EXPECT_EQ(run("optimize " + spot() + " -o o.glb -p p.toml").code, 1);
}

TEST_F(Compare, AllAreJudgedByTheSubjectsOfTheFirst) {
  put(folder_ / "whole.toml", "pipeline = 1\nstages = ['weld']\n[subjects]\nsubject = 'scene'\n");
  const auto subjects = [&](const std::string& pipelines) {
    std::vector<std::string> told;
    const Ended ended =
        run("compare " + spot() + ' ' + pipelines + " --with 'overdraw-raster(views=12,size=32)' --json");
    const Json json = Json::parse(ended.out);
    for (const Json& branch : json["files"][0]["branches"]) {
      told.push_back(branch["report"]["evaluators"]["overdraw-raster"]["options"]["subject"]);
    }
    return told;
  };
  EXPECT_EQ(subjects("-p whole.toml -p weld"), (std::vector<std::string>{"scene", "scene"}));
  EXPECT_EQ(subjects("-p weld -p whole.toml"), (std::vector<std::string>{"character", "character"}));
}

TEST_F(Compare, StagesBeforeTheForkRunOnce) {
  put(folder_ / "p.toml", "pipeline = 1\nstages = ['weld', 'lookahead']\n[compare]\na = ['vertex-fetch']\nb = []\n");
  const Json file = compared("-p p.toml --repeat 3");
  for (const std::size_t stage : {0u, 1u}) {  // the very same runs
    EXPECT_EQ(file["branches"][0]["report"]["stages"][stage]["rounds"],
              file["branches"][1]["report"]["stages"][stage]["rounds"]);
  }
}

TEST_F(Compare, SweepsAnOption) {
  const Json file = compared("-p weld -p tipsify --sweep tipsify.cache-size=8:32:8 --front time,vertex-cache.acmr");
  EXPECT_EQ(names(file),
            (std::vector<std::string>{"weld", "tipsify with tipsify.cache-size=8", "tipsify with tipsify.cache-size=16",
                                      "tipsify with tipsify.cache-size=24", "tipsify with tipsify.cache-size=32"}));
  for (const std::size_t other : {1u, 4u}) EXPECT_LT(acmr(file["branches"][2]), acmr(file["branches"][other]));
  const Json& front = file["fronts"][0];
  EXPECT_EQ(front["x"], "time");
  EXPECT_THAT(front["branches"].get<std::vector<int>>(), ::testing::Contains(2));
}

TEST_F(Compare, APipelineThatCanNotBePlannedLosesNoOther) {
  const Ended ended = run("compare " + spot() + " -p tipsfy -p weld -p tipsify --with vertex-cache --json");
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("did you mean 'tipsify'?"));
  const Json file = Json::parse(ended.out)["files"][0];
  EXPECT_EQ(file["branches"][0]["lost"], true);
  EXPECT_GT(acmr(file["branches"][1]), acmr(file["branches"][2]));
  // Nor does the next one stand in for the baseline.
  const Ended judged = run("compare " + spot() +
                           " -p tipsfy -p weld --with vertex-cache --fail-if 'vertex-cache.acmr > baseline * 0.1'");
  EXPECT_EQ(judged.code, 1);
  EXPECT_THAT(judged.err, HasSubstr("the first pipeline has no figure"));
}

TEST_F(Compare, WritesATableOfValues) {
  ASSERT_EQ(run("compare " + spot() + " -p tipsify --with vertex-cache --csv t.csv").code, 0);
  const std::string table = content(folder_ / "t.csv");
  EXPECT_TRUE(table.starts_with("file,branch,pipeline,draw,name,evaluator,metric,value,unit,error\r\n")) << table;
  EXPECT_THAT(table, HasSubstr(",[1],tipsify,,,vertex-cache,acmr,0."));
  EXPECT_THAT(table, HasSubstr(",[1],tipsify,,,time,tipsify,"));
}

TEST_F(Compare, WritesAPage) {
  ASSERT_EQ(run("compare " + spot() + " -p tipsify -p lookahead --html c.html --with vertex-cache").code, 0);
  const std::string page = content(folder_ / "c.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_THAT(page, HasSubstr("data-branch=\"1\">[2]</th>"));
  ASSERT_EQ(run("optimize " + spot() + " -o o.glb -p tipsify --html o.html").code, 0);
  EXPECT_THAT(content(folder_ / "o.html"), HasSubstr("<code>tipsify</code>"));
}

TEST_F(Compare, TellsMemoryStageByStage) {
  const Json stage = compared("-p tipsify")["branches"][0]["report"]["stages"][0];
  if (!stage.contains("memory")) GTEST_SKIP() << "this system does not tell";
  EXPECT_LT(stage["memory"], 100'000'000);
}

class CompareMistakes : public Compare, public ::testing::WithParamInterface<Mistake> {};

TEST_P(CompareMistakes, AreToldInOneClearLineBeforeTheWork) {
  put(folder_ / "newer.json", "{\"report\": 99}");
  put(folder_ / "old.json", R"({"batch": 1, "files": []})");
  put(folder_ / "noise.json", "not JSON");
  put(folder_ / "empty.toml", "pipeline = 1\ncompare = {}\n");
  expect_told(GetParam(), run("compare " + spot() + ' ' + GetParam().arguments));
}

INSTANTIATE_TEST_SUITE_P(
    Every, CompareMistakes,
    ::testing::Values(
        Mistake{"bad_bound", "--fail-if 'acmr > 1'", 1, "expected EVALUATOR.METRIC or time"},
        Mistake{"bound_without_baseline", "-p weld --fail-if 'x.y > baseline'", 1, "--baseline"},
        Mistake{"baseline_not_there", "-p weld --fail-if 'x.y > baseline' --baseline no.json", 1, "no.json"},
        Mistake{"baseline_alone_not_there", "-p weld --baseline no.json", 1, "no.json"},
        Mistake{"baseline_is_newer", "--fail-if 'x.y > baseline' --baseline newer.json", 1, "version 99"},
        Mistake{"baseline_is_noise", "--fail-if 'x.y > baseline' --baseline noise.json", 1, "is not a JSON object"},
        Mistake{"report_in_no_folder", "--report no/r.json", 2, "no folder 'no'"},
        Mistake{"page_in_no_folder", "--html no/r.html", 2, "no folder 'no'"},
        Mistake{"two_outputs_in_one_file", "--html r --csv ./r", 1, "r: error: is named for two outputs"},
        Mistake{"page_in_a_pipelines_place", "-p empty.toml --html empty.toml", 1, "'compare' has no pipelines"},
        Mistake{"page_in_a_buffers_place", "--html in/bench.bin", 1,
                "in/bench.bin: error: has the extension of a scene"},
        Mistake{"table_in_a_baselines_place",
                "--fail-if 'vertex-cache.acmr > baseline' --baseline old.json --csv old.json", 1,
                "old.json: error: is an input of this run"},
        Mistake{"sweep_of_an_evaluator", "-p tipsify --sweep vertex-cache.cache-size=8,16", 1, "measured alike"},
        Mistake{"page_to_standard_output", "--html -", 1, "take the name of a file"},
        Mistake{"empty_sweep", "--sweep tipsify.cache-size=", 1, "a value is empty"},
        Mistake{"sweep_that_leads_nowhere", "--sweep tipsify.cache-size=9:1:1", 1,
                "steps of 1 do not lead from 9 to 1"},
        Mistake{"sweep_of_no_stage", "-p weld --sweep tipsify.cache-size=8:16:8", 1, "no stage 'tipsify'"},
        Mistake{"front_of_one", "--front time", 1, "expected two figures, found 'time'"},
        Mistake{"front_of_nobody", "--front time,vertex-cash.acmr", 1,
                "--front: error: there is no figure 'vertex-cash.acmr': figures come from "},
        Mistake{"bound_of_nobody", "--fail-if 'x.y > 1'", 1, "--fail-if: error: there is no figure 'x.y'"},
        Mistake{"no_rows", "-p empty.toml", 1, "empty.toml:2:11: error: compare: 'compare' has no pipelines"}),
    testing::by_what);

TEST_F(Compare, AFrontOfFiguresThatNobodyHasIsTold) {
  const Ended ended = run("compare " + spot() + " -p weld --with vertex-cache --front time,vertex-cache.acm");
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("no pipeline has the figure 'vertex-cache.acm' that --front names"));
  EXPECT_THAT(ended.out, HasSubstr("acmr"));  // the comparison is told all the same
}

}  // namespace
}  // namespace foredraw::compare_test
