// A folder that is worked on night after night: what a changed pipeline does again, and what changed since last time.

#include "support/on_corpus.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace foredraw::batch_nights_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

class BatchNights : public testing::OnCorpus {
 protected:
  BatchNights() { fs::create_directories(folder_ / "in/props"); }

  Json report() { return Json::parse(content(folder_ / "r.json")); }
};

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
}  // namespace foredraw::batch_nights_test
