// Modules that were built with the headers of version 1.0 load in every program that speaks version 1: these files are
// never built again.
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

namespace foredraw::testing::first_version_test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class FirstVersion : public InFolder, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
#ifndef __x86_64__
    GTEST_SKIP() << "the modules that are kept are for x86-64";
#endif
  }
  static std::string file(const std::string& name) {
    return "--modules " + std::string(GetParam()) + " --module '" FOREDRAW_SOURCE_DIR "/tests/modules/first_version/" +
           name + "-x86_64.so' ";
  }
  Json optimized(const std::string& arguments, int code = 0) {
    const Ended ended = run_program(
        folder_, "optimize '" FOREDRAW_SOURCE_DIR "/benchmarks/corpus/static/spot.glb' -o out.glb --json " + arguments);
    EXPECT_EQ(ended.code, code) << ended.err << ended.out;
    return Json::parse(ended.out, nullptr, false);
  }
};

TEST_P(FirstVersion, GivesTheBytesOfTheSameTechniqueOfToday) {
  const std::string stages = " -p 'weld, acme-radial(height=.25), vertex-fetch' --with vertex-cache";
  optimized(file("radial") + stages);
  const std::string bytes = content(folder_ / "out.glb");
  optimized("--module '" FOREDRAW_MODULES_FOLDER "/radial.so'" + stages);
  EXPECT_TRUE(content(folder_ / "out.glb") == bytes);
}

TEST_P(FirstVersion, HasAllThatThatVersionHad) {
  const std::string stages =
      "-p 'first-backwards(flag=true, whole=-7, real=2.5, text=\"th\", word=\"b\"), first-pairs, first-never, "
      "first-vertices' --with first-corners";
  const Json report = optimized(file("everything") + stages);
  EXPECT_THAT(report.dump(), HasSubstr("it is turned"));
  EXPECT_THAT(report.dump(), HasSubstr("it was good in the first version"));
  for (const Json& stage : report.at("stages")) {
    EXPECT_EQ(stage.at("changed"), stage.at("use") == "first-never" ? 0 : 1) << stage;
  }
  const Json& figures = report.at("totals").at("metrics").at("first-corners");
  EXPECT_EQ(figures.at("corners").at("value"), 3 * 5856);
  EXPECT_DOUBLE_EQ(figures.at("share").at("value"), 5856.0 / 3225);
  EXPECT_EQ(figures.at("share").at("error"), 0.25);
  EXPECT_THAT(optimized(file("everything") + "-p first-backwards --with first-corners").dump(),
              HasSubstr("it is not turned"));
  EXPECT_THAT(optimized(file("everything") + "-p first-fails --with first-corners", 2).dump(),
              HasSubstr("it failed in the first version"));
}

INSTANTIATE_TEST_SUITE_P(Ways, FirstVersion, ::testing::Values("apart", "inside"));

}  // namespace
}  // namespace foredraw::testing::first_version_test
