// A folder that is worked on night after night: what a changed pipeline does again, and what changed since last time.

#include "support/on_corpus.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace foredraw {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

class BatchNights : public testing::OnCorpus {
 protected:
  BatchNights() { fs::create_directories(folder_ / "in/props"); }

  Json report() { return Json::parse(content(folder_ / "r.json")); }
  /// Without what differs from run to run.
  static Json without_times(Json json) {
    if (json.is_object()) {
      for (const char* key : {"seconds", "peak-memory", "cached"}) json.erase(key);
    }
    for (Json& held : json) {
      if (held.is_structured()) held = without_times(std::move(held));
    }
    return json;
  }
};

/// Its first stage takes longer than to keep what it came to.
TEST_F(BatchNights, AChangedLastStageDoesNotRedoTheFirst) {
  copy("static/spot.glb", "model.glb");
  const auto command = [](const std::string& last, const std::string& rest) {
    return "optimize model.glb -o a.glb --threads 1 --report r.json --with vertex-cache -p 'occlusion-order, " + last +
           "' --set views.count=642 " + rest;
  };
  const auto stages_cached = [&] {
    std::string cached;
    const Json whole = report();
    for (const Json& stage : whole["stages"]) cached += stage.value("cached", false) ? '1' : '0';
    return cached;
  };
  ASSERT_EQ(run(command("vertex-fetch", "--cache cache")).code, 0);
  EXPECT_EQ(stages_cached(), "00");
  for (const char* last : {"weld", "weld, vertex-fetch"}) {
    const Ended ended = run(command(last, "--cache cache"));
    ASSERT_EQ(ended.code, 0);
    EXPECT_THAT(ended.err, ContainsRegex("occlusion-order.* m?s, from the cache\n"));
    EXPECT_EQ(stages_cached().substr(0, 2), "10");
    EXPECT_EQ(report()["measures"].size(), 1u);
    const std::string resumed = content(folder_ / "a.glb");
    const Json told = without_times(report());
    ASSERT_EQ(run(command(last, "")).code, 0);
    EXPECT_EQ(content(folder_ / "a.glb") == resumed, true) << last;
    EXPECT_EQ(without_times(report()), told) << last;
  }
  ASSERT_EQ(run(command("vertex-fetch", "--cache cache --set seed=7")).code, 0);
  EXPECT_EQ(stages_cached(), "00") << "another seed";
}

TEST_F(BatchNights, WhatChangedSinceTheLastRunIsToldWorstFirst) {
  copy("static/spot.glb", "in/spot.glb");
  copy("scenes/kaykit_city/bench.gltf", "in/props/bench.gltf");
  copy("scenes/kaykit_city/bench.bin", "in/props/bench.bin");
  for (const int i : {0, 1}) put_quad("in/props/quad" + std::to_string(i) + ".obj", i);
  const std::string run_with = "optimize in -o out --with vertex-cache --report ";
  ASSERT_EQ(run(run_with + "old.json -p 'tipsify, vertex-fetch'").code, 0);
  fs::remove(folder_ / "in/props/quad0.obj");
  put_quad("in/props/quad7.obj", 7);
  const Ended same = run(run_with + "r.json -p 'tipsify, vertex-fetch' --baseline old.json --cache cache");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.err, HasSubstr("since old.json: none is worse, none is better; 3 files are the same\n"
                                  "1 file new:\n  in/props/quad7.obj\n1 file gone:\n  in/props/quad0.obj\n"));
  const Ended worse = run(run_with + "r.json -p 'weld' --baseline old.json");
  EXPECT_THAT(worse.err, HasSubstr("are worse, none is better"));
  const Json since = report()["since"];
  ASSERT_GE(since["changed"].size(), 2u);
  EXPECT_EQ(since["changed"][0]["worse"], true);
  EXPECT_EQ(since["new"], Json::parse(R"(["in/props/quad7.obj"])"));
  std::string parts;
  for (const char* part : {"1", "2"}) {
    const std::string of_part = std::string("p") + part + ".json";
    EXPECT_THAT(run(run_with + of_part + " -p weld --baseline old.json --shard " + part + "/2").err,
                Not(HasSubstr("gone")));
    parts += of_part + ' ';
  }
  EXPECT_THAT(run("join-reports p1.json --baseline old.json").out, Not(HasSubstr("gone")));
  EXPECT_THAT(run("join-reports " + parts + "--baseline old.json -o joined.json").out,
              HasSubstr(worse.err.substr(worse.err.find("since old.json"))));
  EXPECT_EQ(Json::parse(content(folder_ / "joined.json"))["since"], since);
  EXPECT_EQ(run("join-reports " + parts + "--baseline no.json").code, 1);
  const Ended compared = run("compare in -p weld --with vertex-cache --baseline old.json");
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.out, HasSubstr("are worse, none is better"));
  EXPECT_EQ(run("optimize in/spot.glb -o a.glb --baseline old.json").code, 1);
  EXPECT_EQ(run("optimize in -o out --baseline no.json").code, 1);
  testing::put(folder_ / "noise.json", "noise");
  EXPECT_EQ(run("optimize in -o out --baseline noise.json").code, 1);
}

}  // namespace
}  // namespace foredraw
