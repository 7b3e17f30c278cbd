// A technique gives the same bytes, whatever it is written in and wherever it runs.
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace foredraw::testing::modules_same_bytes_test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

const std::string corpus = FOREDRAW_SOURCE_DIR "/benchmarks/corpus/";
const std::string modules = FOREDRAW_MODULES_FOLDER "/";

class Modules : public InFolder {
 protected:
  /// What a program writes, with these arguments besides.
  std::string written(const std::string& program, const std::string& model, const std::string& arguments) {
    const std::string command = "cd '" + folder_.string() + "' && '" + program + "' optimize '" + corpus + model +
                                "' -o out.glb --with vertex-cache " + arguments + " >log 2>&1 </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command << '\n' << content(folder_ / "log");
    return content(folder_ / "out.glb");
  }
};

TEST_F(Modules, GiveTheBytesOfATechniqueThatIsBuiltIn) {
  const std::string module = " --module '" + modules + "radial.so'";
  for (const std::string model : {"static/spot.glb", "animated/kaykit_knight.glb"}) {
    for (const std::string pipeline : {"weld, acme-radial, vertex-fetch", "acme-radial(height=.25)"}) {
      const std::string stages = " -p '" + pipeline + "'";
      const std::string built_in = written(FOREDRAW_WITH_RADIAL, model, stages);
      EXPECT_EQ(built_in, written(FOREDRAW_PROGRAM, model, stages + module)) << model;
      EXPECT_EQ(built_in, written(FOREDRAW_PROGRAM, model, stages + module + " --threads 1")) << model;
      EXPECT_EQ(built_in, written(FOREDRAW_PROGRAM, model, stages + module + " --threads 16")) << model;
      EXPECT_EQ(built_in, written(FOREDRAW_PROGRAM, model, stages + module + " --modules inside")) << model;
    }
  }
}

TEST_F(Modules, BelongToWhatACacheKnowsResultsBy) {
  std::filesystem::copy_file(modules + "radial.so", folder_ / "radial.so");
  std::filesystem::create_directories(folder_ / "in");
  std::filesystem::copy_file(corpus + "static/spot.glb", folder_ / "in/spot.glb");
  const auto comes_from_cache = [&] {
    const Ended ended = run_program(folder_,
                                    "optimize in -o out --report r.json --cache cache --module radial.so "
                                    "-p 'acme-radial, vertex-fetch' --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << ended.err;
    return Json::parse(content(folder_ / "r.json"))["files"][0].value("cached", false);
  };
  EXPECT_FALSE(comes_from_cache());
  EXPECT_TRUE(comes_from_cache());
  std::ofstream(folder_ / "radial.so", std::ios::app) << "another build";
  EXPECT_FALSE(comes_from_cache());
}

TEST_F(Modules, InRustDoSo) {
#ifdef FOREDRAW_RADIAL_RS
  const std::string stages = " -p 'weld, acme-radial(height=.25), vertex-fetch'";
  EXPECT_EQ(written(FOREDRAW_WITH_RADIAL, "animated/kaykit_knight.glb", stages),
            written(FOREDRAW_PROGRAM, "animated/kaykit_knight.glb", stages + " --module '" FOREDRAW_RADIAL_RS "'"));
#else
  GTEST_SKIP() << "there is no rustc; packages/install test brings it";
#endif
}

/// Modules in Python, as their users run them.
class PythonModules : public Modules {
 protected:
#ifdef FOREDRAW_PYTHON
  void SetUp() override {
    if (std::system(FOREDRAW_PYTHON " -c 'import numpy' 2>/dev/null") != 0) {
      GTEST_SKIP() << FOREDRAW_PYTHON " has no numpy; packages/install test brings it";
    }
    setenv("FOREDRAW_PYTHON", FOREDRAW_PYTHON, 1);
    setenv("FOREDRAW_LIBRARY", FOREDRAW_LIBRARY, 1);
    setenv("PYTHONPATH", FOREDRAW_SOURCE_DIR "/hosts/python", 1);
    setenv("PYTHONDONTWRITEBYTECODE", "1", 1);
  }
#else
  void SetUp() override { GTEST_SKIP() << "there is no python3, or this build is watched by a sanitizer"; }
#endif
};

TEST_F(PythonModules, GiveTheBytesOfATechniqueThatIsBuiltIn) {
  const std::string stages = " -p 'weld, acme-radial(height=.25), vertex-fetch'";
  const std::string module = " --module '" FOREDRAW_SOURCE_DIR "/hosts/module/examples/radial.py'";
  const std::string built_in = written(FOREDRAW_WITH_RADIAL, "animated/kaykit_knight.glb", stages);
  EXPECT_EQ(built_in, written(FOREDRAW_PROGRAM, "animated/kaykit_knight.glb", stages + module));
  EXPECT_EQ(built_in, written(FOREDRAW_PROGRAM, "animated/kaykit_knight.glb", stages + module + " --threads 1"));
}

TEST_F(PythonModules, SayWhereTheyFailed) {
  put(folder_ / "bad.py",
      "import foredraw as fd\n\n@fd.orderer('acme-bad')\ndef bad(draw):\n    return draw.nothing\n");
  put(folder_ / "broken.py", "import foredraw as fd\n\nthis is no Python\n");
  put(folder_ / "none.py", "x = 1\n");
  const std::string model = "'" + corpus + "static/spot.glb'";
  Ended ended = run_program(folder_, "optimize " + model + " -o out.glb -p acme-bad --module bad.py");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("AttributeError"));
  EXPECT_THAT(ended.err, HasSubstr("line 5 of"));
  ended = run_program(folder_, "list --module broken.py");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("SyntaxError"));
  ended = run_program(folder_, "list --module none.py");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("none of its functions is decorated with @foredraw.orderer"));
  put(folder_ / "short.py", "import foredraw as fd\n\n@fd.orderer('short')\ndef short(draw):\n    return []\n");
  ended = run_program(folder_, "list --module short.py");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("'short' must begin with its vendor's name, such as 'acme-short'"));
  ended = run_program(folder_, "list --module none.py --modules inside");
  EXPECT_THAT(ended.err, HasSubstr("a module in Python runs in a process of its own alone"));
  ended = run_program(folder_, "list --module none.py", "FOREDRAW_PYTHON=no-such-program");
  EXPECT_THAT(ended.err, HasSubstr("there is no program no-such-program"));
  put(folder_ / "lacks.py", "import no_such_package\n");
  ended = run_program(folder_, "list --module lacks.py");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("FOREDRAW_PYTHON names another python3"));
}

TEST_F(Modules, AreKnownAsBuiltInOnesAre) {
  const std::string module = " --module '" + modules + "radial.so'";
  const auto told = [&](const std::string& arguments, int code = 0) {
    const Ended ended = run_program(folder_, arguments + module);
    EXPECT_EQ(ended.code, code) << ended.err;
    return ended.out + ended.err;
  };
  EXPECT_THAT(told("list"), HasSubstr("acme-radial"));
  EXPECT_THAT(told("show acme-radial"), HasSubstr("| `height` | 1.0 | number, 0 to 10 | How much height counts |"));
  EXPECT_THAT(told("show acme-radial"), HasSubstr("radial.so, version 1.0.0"));
  EXPECT_TRUE(Json::parse(told("schema")).dump().find("acme-radial") != std::string::npos);
  const std::string plan = "plan '" + corpus + "static/spot.glb' -p ";
  EXPECT_THAT(told(plan + "acme-radial"), HasSubstr("acme-radial"));
  EXPECT_THAT(told(plan + "acme-radail", 1), HasSubstr("did you mean 'acme-radial'?"));
  EXPECT_THAT(told(plan + "'acme-radial(height=11)'", 1), HasSubstr("'height' is 11.0, but must be 0 to 10"));
}

TEST_F(Modules, StandInTheReportWithHashAndVersion) {
  const Ended ended = run_program(folder_, "optimize '" + corpus +
                                               "static/spot.glb' -o out.glb --json -p acme-radial "
                                               "--with vertex-cache --module '" +
                                               modules + "radial.so' --module '" + modules + "keeps.so'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json named = Json::parse(ended.out).at("modules");
  ASSERT_EQ(named.size(), 1u) << "those that took part";
  EXPECT_EQ(named[0].at("version"), "1.0.0");
  EXPECT_EQ(named[0].at("vendor"), "acme");
  EXPECT_EQ(named[0].at("runs"), "apart");
  EXPECT_EQ(named[0].at("hash").get<std::string>().size(), 32u);
}

TEST_F(Modules, AreNamedByTheEnvironmentAsWell) {
  const std::string known = "FOREDRAW_MODULES='" + modules + "keeps.so:" + modules + "radial.so'";
  EXPECT_THAT(run_program(folder_, "list", known).out, HasSubstr("acme-radial"));
}

TEST_F(Modules, MayBeDemandedByPipelines) {
  const std::string plan = "plan '" + corpus + "static/spot.glb' -p line.toml";
  const std::string module = " --module '" + modules + "radial.so'";
  const auto demands = [&](const std::string& demand) {
    put(folder_ / "line.toml", "pipeline = 1\nmodules = [\"" + demand + "\"]\nstages = [\"weld\"]\n");
  };
  demands("acme >= 1.0");
  EXPECT_EQ(run_program(folder_, plan + module).code, 0);
  Ended ended = run_program(folder_, plan);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("line.toml:2:12: error: modules[0]: it needs the module 'acme >= 1.0', which is not "
                                   "loaded"));
  EXPECT_THAT(ended.err, HasSubstr("--module"));
  demands("acme >= 1.0.1");
  ended = run_program(folder_, plan + module);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("radial.so is 1.0.0"));
}

TEST_F(Modules, AreNotNamedByPipelines) {
  put(folder_ / "line.toml", "pipeline = 1\nmodule = \"" + modules + "radial.so\"\nstages = [\"acme-radial\"]\n");
  const Ended ended = run_program(folder_, "plan '" + corpus + "static/spot.glb' -p line.toml");
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("module"));
}

}  // namespace
}  // namespace foredraw::testing::modules_same_bytes_test
