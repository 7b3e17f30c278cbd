// What may go wrong while the program watches a folder: it is told, and nothing is lost.

#include "watching.h"

#include <gmock/gmock.h>

namespace foredraw::watch_faults_test {
namespace {

namespace fs = std::filesystem;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Running;

class WatchFaults : public testing::Watching {};

TEST_F(WatchFaults, AFileThatIsWrongIsToldAndLosesNothing) {
  put_quad("in/a.obj", 1);
  Running program = watching();
  program.tells("1 file up to date");
  const std::string before = output("a.glb");
  testing::put(folder_ / "in/a.obj", "v 0 0 none\nf 1 2 3\n");
  program.tells("a.obj: failed; its output stays as it was");
  EXPECT_THAT(program.told(), HasSubstr("in/a.obj:1"));
  EXPECT_TRUE(output("a.glb") == before);
  put_quad("in/a.obj", 2);
  program.tells("a.obj: written", 2);
  EXPECT_EQ(program.end(), 0) << "whatever failed";
}

TEST_F(WatchFaults, TwoScenesDoNotBecomeOneFile) {
  put_quad("in/a.obj", 1);
  Running program = watching();
  program.tells("1 file up to date");
  const std::string before = output("a.glb");
  copy("static/spot.glb", "in/a.glb");
  program.tells("the outputs of a.obj and a.glb would both have this name");
  EXPECT_TRUE(output("a.glb") == before);
  fs::remove(folder_ / "in/a.obj");
  program.tells("a.obj: is gone");
  copy("static/spot.glb", "in/a.glb");
  program.tells("a.glb: written");
}

/// At many moments of its work: an output is whole or not there.
TEST_F(WatchFaults, CtrlCLeavesNothingHalfDone) {
  copy("animated/kaykit_knight.glb", "in/knight.glb");
  copy("static/spot.glb", "in/spot.glb");
  for (int i = 0; i < 8; ++i) {
    fs::remove_all(folder_ / "out");
    Running program = watching("--with vertex-cache");
    program.tells("watching in");
    testing::comes_true([&] { return program.worked() >= .1 * i || program.count("up to date") > 0; });
    EXPECT_EQ(program.end(), 0) << program.told();
    if (!fs::exists(folder_ / "out")) continue;
    for (const std::string& name : all_files("out")) {
      EXPECT_THAT(name, Not(HasSubstr("foredraw-part")));
      EXPECT_EQ(testing::run_program(folder_, "measure out/" + name + " --with vertex-cache").code, 0) << name;
    }
  }
}

TEST_F(WatchFaults, NamesThatAreNotUtf8ArePassedBy) {
  Running program = watching();
  program.tells("waiting for changes");
  put_quad("in/\xFF.obj", 1);
  if (!fs::exists(folder_ / "in/\xFF.obj")) GTEST_SKIP() << "this file system takes no such names";
  put_quad("in/a.obj", 1);
  program.tells("a.obj: written");
  program.tells(".obj: is passed by: its name is not UTF-8");
  EXPECT_EQ(program.count("failed"), 0);
  EXPECT_THAT(all_files("out"), ::testing::ElementsAre("a.glb"));
}

TEST_F(WatchFaults, AFolderThatGoesAwayEndsIt) {
  put_quad("in/a.obj", 1);
  Running program = watching();
  program.tells("1 file up to date");
  fs::rename(folder_ / "in", folder_ / "elsewhere");
  EXPECT_EQ(program.ended(), 2);
  EXPECT_THAT(program.told(), HasSubstr("in: error: was removed or renamed while it was watched"));
}

TEST_F(WatchFaults, WhatCanNotBeWatchedIsRefused) {
  put_quad("in/a.obj", 1);
  const auto refused = [&](const std::string& arguments) {
    const Ended ended = testing::run_program(folder_, "watch " + arguments);
    EXPECT_EQ(ended.code, 1) << ended.out << ended.err;
    return ended.err;
  };
  EXPECT_THAT(refused("in/a.obj -o out"), HasSubstr("is no folder"));
  EXPECT_THAT(refused("nowhere -o out"), HasSubstr("there is no such folder"));
  EXPECT_THAT(refused("in -o in/../in"), HasSubstr("is the input folder itself"));
  EXPECT_THAT(refused("in -o in/a.obj"), HasSubstr("is not a folder"));
  EXPECT_THAT(refused("in -o remap:a.json"), HasSubstr("the input is a folder"));
  EXPECT_THAT(refused("in -o out -p 'tipsify('"), HasSubstr("error"));
  EXPECT_THAT(refused("in -o out -p tipsfy"), HasSubstr("did you mean 'tipsify'?"));
  EXPECT_THAT(refused("in -o out --settle 0"), HasSubstr("--settle"));
  EXPECT_THAT(refused("in"), HasSubstr("--output"));
}

}  // namespace
}  // namespace foredraw::watch_faults_test
