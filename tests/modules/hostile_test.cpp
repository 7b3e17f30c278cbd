// Modules that misbehave cost their own stage, and nothing else.
#include "left_behind.h"
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

namespace foredraw::testing::hostile_test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string knight = "'" FOREDRAW_SOURCE_DIR "/benchmarks/corpus/animated/kaykit_knight.glb'";

struct Hostile {
  std::string name;
  int code;          ///< that the program ends with; -1: 0 or 2, as chance will have it
  std::string says;  ///< in the report
  std::string arguments = "";
};

/// So that a failing test says which.
void PrintTo(const Hostile& module, std::ostream* out) { *out << module.name; }

class HostileModules : public InFolder, public ::testing::WithParamInterface<Hostile> {
 protected:
  void SetUp() override {
    if (is_sanitized) GTEST_SKIP() << "sanitizers have words of their own for what ends a process";
  }

  Json optimized(const std::string& arguments, int code) {
    const Ended ended = run_program(folder_, "optimize " + knight + " -o out.glb --json " + arguments);
    EXPECT_TRUE(ended.code == code || (code < 0 && ended.code != 1)) << ended.code << ended.err;
    EXPECT_TRUE(Json::accept(ended.out)) << ended.out;
    return Json::parse(ended.out, nullptr, false);
  }
};

TEST_P(HostileModules, CostTheirStageAlone) {
  const Hostile& hostile = GetParam();
  optimized("-p 'weld, tipsify, vertex-fetch' --with vertex-cache", 0);
  const std::string without = content(folder_ / "out.glb");
  std::filesystem::remove(folder_ / "out.glb");
  const std::string module = module_in(folder_, hostile.name);
  const bool measures =
      hostile.name == "not-finite" || hostile.name == "negative-error" || hostile.name == "other-metric";
  const std::string stage =
      hostile.name.starts_with("remesher-") ? std::string("hostile-remesher") : "hostile-" + hostile.name;
  const Json report = optimized("--module '" + module + "' " + hostile.arguments +
                                    (measures ? " -p 'weld, tipsify, vertex-fetch' --with 'vertex-cache, " + stage + "'"
                                              : " -p 'weld, " + stage + ", tipsify, vertex-fetch' --with vertex-cache"),
                                hostile.code);
  EXPECT_TRUE(content(folder_ / "out.glb") == without) << "the stage changed what others make";
  EXPECT_THAT(report.dump(), HasSubstr(hostile.says));
  EXPECT_THAT(workers_left(folder_), IsEmpty());
  EXPECT_THAT(files(), ::testing::UnorderedElementsAre(hostile.name + ".so", "out.glb"));
}

INSTANTIATE_TEST_SUITE_P(
    Answers, HostileModules,
    ::testing::Values(Hostile{"twin", 2, "is not a permutation"}, Hostile{"beyond", 2, "is not a permutation"},
                      Hostile{"too-short", 2, "order of 1 entries is not a permutation"},
                      Hostile{"count-raised", 2, "but there is room for"},
                      Hostile{"nothing-written", 2, "is not a permutation"},
                      Hostile{"answers-late", -1, "\"report\":1"}, Hostile{"fails", 2, "the moon\xEF\xBF\xBDis"},
                      Hostile{"keeps", 0, "it is good already"}, Hostile{"not-finite", 2, "is not a finite number"},
                      Hostile{"negative-error", 2, "is negative"},
                      Hostile{"other-metric", 2, "it has no metric 'sun'"}));

INSTANTIATE_TEST_SUITE_P(
    Ends, HostileModules,
    ::testing::Values(Hostile{"writes-input", 2, "SIGSEGV"}, Hostile{"writes-behind", 2, "SIGSEGV"},
                      Hostile{"frees-lent", 2, "process was ended by SIG"}, Hostile{"null", 2, "SIGSEGV"},
                      Hostile{"aborts", 2, "SIGABRT; it wrote: the moon is full"}, Hostile{"overflows", 2, "SIGSEGV"},
                      Hostile{"exits", 2, "left without an answer (exit code 0)"}, Hostile{"throws", 2, "SIGABRT"},
                      Hostile{"jumps", 2, "failed", "--module-seconds 1"}, Hostile{"kills-itself", 2, "SIGKILL"},
                      Hostile{"stops-itself", 2, "SIGSTOP"}, Hostile{"kills-parent", 2, "its process is no more"},
                      Hostile{"spins", 2, "it gave no answer within 0.5 seconds", "--module-seconds .5"},
                      Hostile{"takes-memory", 2, "bytes of memory that it may have", "--module-memory 200M"}));

INSTANTIATE_TEST_SUITE_P(Surroundings, HostileModules,
                         ::testing::Values(Hostile{"forks", 0, "\"report\":1"}, Hostile{"prints", 0, "\"report\":1"},
                                           Hostile{"closes", 0, "\"report\":1"}, Hostile{"upsets", 0, "\"report\":1"},
                                           Hostile{"many-notes", 0, "9900 more notes are left out"},
                                           Hostile{"long-text", 0, "mmmmmmmm", "--module-memory 4G"}));

INSTANTIATE_TEST_SUITE_P(Remeshers, HostileModules,
                         ::testing::Values(Hostile{"remesher-beyond", 2, "an index to vertex"},
                                           Hostile{"remesher-from_beyond", 2, "a vertex from vertex"},
                                           Hostile{"remesher-unwritten", 2, "a vertex from vertex 4294967295"},
                                           Hostile{"remesher-odd_count", 2, "which is no multiple of three"},
                                           Hostile{"remesher-more_triangles", 2, "but there is room for"},
                                           Hostile{"remesher-more_vertices", 2, "vertices, but there is room for"},
                                           Hostile{"remesher-none_left", 2, "it leaves no triangle of"},
                                           Hostile{"remesher-no_vertices", 2, "it leaves no vertex of"},
                                           Hostile{"remesher-lossless", 2, "it would draw other triangles than before"},
                                           Hostile{"remesher-exits", 2, "left without an answer (exit code 7)"},
                                           Hostile{"remesher-counts_overdraw", 2, "it may not ask for overdraw"}));

INSTANTIATE_TEST_SUITE_P(Askers, HostileModules,
                         ::testing::Values(Hostile{"asks-wrong", 0, "no order, no order, an order"},
                                           Hostile{"asks-for-ever", 2, "it gave no answer within 0.5 seconds",
                                                   "--module-seconds .5"},
                                           Hostile{"asks-and-exits", 2, "left without an answer (exit code 3)"}));

TEST_F(HostileModules, AreLeftOutAfterThreeDeaths) {
  const Json report =
      optimized("--module '" + module_in(folder_, "aborts") + "' -p hostile-aborts --with vertex-cache --threads 1", 2);
  int died = 0, left_out = 0;
  for (const Json& diagnostic : report.at("diagnostics")) {
    const std::string message = diagnostic.at("message");
    died += message.find("SIGABRT") != std::string::npos ? 1 : 0;
    left_out += message.find("its module is left out") != std::string::npos ? 1 : 0;
    EXPECT_THAT(diagnostic.dump(), HasSubstr("hostile-aborts"));
  }
  EXPECT_EQ(died, 3);
  EXPECT_EQ(died + left_out, report.at("draws").size());
}

TEST_F(HostileModules, EndWithAProgramThatIsKilled) {
  const std::string command = "'" FOREDRAW_PROGRAM "' optimize " + knight + " -o '" + (folder_ / "out.glb").string() +
                              "' -p hostile-spins --with vertex-cache --module '" + module_in(folder_, "spins") +
                              "' >/dev/null 2>&1 & echo $! >'" + (folder_ / "pid").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(a_worker_spins(folder_));
  ASSERT_EQ(std::system(("kill -9 $(cat '" + (folder_ / "pid").string() + "')").c_str()), 0);
  EXPECT_THAT(workers_left(folder_), IsEmpty());
}

}  // namespace
}  // namespace foredraw::testing::hostile_test
