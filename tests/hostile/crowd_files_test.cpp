// Crowds of nobody, of one, of all at one place, without a budget, and that pass through themselves, through the
// program.
#include "displaced_parts.h"

#include "support/expect_numbers.h"

#include <cmath>

namespace foredraw::crowd_files_test {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::Ended;

class CrowdFiles : public testing::InFolder {
 protected:
  CrowdFiles() {
    testing::Parts parts;
    parts.become_sheet(8, 8, [](int x, int y) {
      return std::array{float(x), float(y), float(std::cos(x) * std::cos(y))};
    });
    testing::put(folder_ / "a.glb", parts.glb());
  }

  Ended run(const std::string& command) { return testing::run_program(folder_, command); }

  /// A crowd with the options of crowd-levels.
  void make(const std::string& options) {
    const std::string command = "optimize a.glb -o b.glb -p 'weld, quadric-collapse, levels, crowd-levels(" + options +
                                ")' --with vertex-cache";
    testing::expect_numbers(run(command), command);
  }

  Ended walk(const std::string& options) {
    const std::string command = "measure b.glb --with 'crowd-cost(frames=4, " + options + ")'";
    Ended ended = run(command);
    testing::expect_numbers(ended, command);
    return ended;
  }
};

/// What a method takes in its most expensive frame, in per cent of the budget.
double most_of_budget(const Ended& ended, const std::string& method) {
  std::smatch found;
  const std::regex line("crowd-cost: " + method + R"(:.* budget, ([0-9.]+) % at most)");
  return std::regex_search(ended.out, found, line) ? std::stod(found[1]) : NAN;
}

constexpr const char* no_choice = "no choice keeps to the budget of ";

TEST_F(CrowdFiles, KeepToTheBudgetWhereverTheyAre) {
  make("characters=4");
  for (const char* options :
       {"instances=1", "instances=4", "instances=100000", "near=1000000, far=0.02", "near=40, far=2", "near=40, far=40",
        "near=0.01, far=0.02", "near=0.01, far=0.02, eye-speed=1000", "near=1000000, far=1000000, eye-speed=0",
        "hysteresis=0", "hysteresis=1", "passes=16, fetching=vertex"}) {
    const Ended ended = walk(options);
    const bool is_too_many = ended.out.find(no_choice) != std::string::npos;
    EXPECT_EQ(is_too_many, std::string(options) == "instances=100000") << options;
    for (const char* method : {"exact", "hysteresis"})
      EXPECT_EQ(most_of_budget(ended, method) <= 100, !is_too_many) << options << ended.out;
  }
}

/// Where eye and characters pass through one another, errors are those seen from where the eye is nearest: a walk of
/// many squares a frame leaves nobody outside.
TEST_F(CrowdFiles, ThatPassThroughThemselvesStayAroundTheEye) {
  make("characters=4");
  const auto rms = [&](const std::string& options) {
    const Ended ended = walk("near=0.01, far=0.02, " + options);
    std::smatch found;
    EXPECT_TRUE(std::regex_search(ended.out, found, std::regex(R"(crowd-cost: constant:.* off by ([0-9.]+) mrad rms)")))
        << ended.out;
    return std::stod(found[1]);
  };
  EXPECT_NEAR(rms("eye-speed=1000"), rms("eye-speed=0.01"), 0.1 * rms("eye-speed=0.01"));
}

TEST_F(CrowdFiles, OfTheLeastBudgetAreToldThatNothingFits) {
  make("characters=1, most=1");
  const Ended ended = walk("instances=1000");
  EXPECT_NE(ended.out.find(no_choice), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("make coarser levels, or raise crowd-levels.characters"), std::string::npos) << ended.out;
  EXPECT_LE(most_of_budget(walk("instances=1"), "exact"), 100);
  make("characters=1000000, most=64");
  EXPECT_LE(most_of_budget(walk("instances=1000"), "exact"), 100);
}

TEST_F(CrowdFiles, OfNobodyAndOfNoLevelAreRefused) {
  for (const char* option : {"characters=0", "characters=nan", "most=0", "most=65", "most=nan", "samples=15"}) {
    const Ended ended =
        run("optimize a.glb -o b.glb -p 'weld, quadric-collapse, levels, crowd-levels(" + std::string(option) + ")'");
    EXPECT_EQ(ended.code, 1) << option;
    const std::string name = std::string(option).substr(0, std::string(option).find('='));
    EXPECT_NE(ended.err.find('\'' + name + '\''), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.glb"));
  }
  for (const char* option : {"instances=0", "frames=0", "near=0", "near=nan", "far=inf", "hysteresis=2", "passes=0"}) {
    const Ended ended = run("measure a.glb --with 'crowd-cost(" + std::string(option) + ")'");
    EXPECT_EQ(ended.code, 1) << option;
    const std::string name = std::string(option).substr(0, std::string(option).find('='));
    EXPECT_NE(ended.err.find('\'' + name + '\''), std::string::npos) << ended.err;
  }
}
#endif

}  // namespace
}  // namespace foredraw::crowd_files_test
