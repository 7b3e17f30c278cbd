// Numbers that are none, of options of lod-walk and lod-table and in files of costs: refused in words, or harmless.
#include "support/program.h"

#include <regex>

namespace foredraw::wrong_costs_test {
namespace {

#ifdef FOREDRAW_PROGRAM
class WrongCosts : public testing::InFolder {
 protected:
  WrongCosts() { testing::put(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"); }

  testing::Ended walk(const std::string& option) {
    return testing::run_program(
        folder_,
        "measure a.obj --with 'lod-walk(frames=2, width=32, height=32, pictures=1, samples=1, " + option + ")'");
  }
  testing::Ended table(const std::string& option) {
    return testing::run_program(folder_, "optimize a.obj -o out.glb -p 'lod-table(" + option + ")'");
  }

  static std::string costs(const std::string& full, const std::string& frame = "frame 1") {
    return "stages max\n" + frame + "\ndraw 1\nfull " + full + "\nwithout-normal-map 0 0 0\nunlit 0 0 0\n";
  }
};

void expect_refused(const testing::Ended& ended, const std::string& words) {
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_NE(ended.err.find(words), std::string::npos) << words << '\n' << ended.err;
}

TEST_F(WrongCosts, OptionsThatAreNoNumbersAreRefused) {
  for (const char* option : {"budget", "share", "noise", "pixels", "focus", "hysteresis"}) {
    for (const char* wrong : {"nan", "inf", "-inf", "-1", "1e300", "text"}) {
      SCOPED_TRACE(std::string(option) + '=' + wrong);
      expect_refused(walk(std::string(option) + '=' + wrong), '\'' + std::string(option) + '\'');
    }
  }
  for (const char* option : {"budget=0", "share=0", "pixels=0", "frames=0", "samples=0", "width=0"}) {
    expect_refused(walk(option), '\'' + std::string(option).substr(0, std::string(option).find('=')) + '\'');
  }
}

TEST_F(WrongCosts, FilesOfCostsThatAreWrongAreRefused) {
  const std::string right = costs("1 1 1");
  for (const std::string& wrong :
       {costs("nan 1 1"), costs("1 inf 1"), costs("1 1 -1"), costs("1 1 1e10"), costs("1 1"), costs("1 1 1 1"),
        costs("0x10 1 1"), costs("1,5 1 1"), costs("1 1 1", "frame"), costs("1 1 1", ""), right + "frame 1\n",
        right + "cost 1\n", right.substr(11), std::string(), std::string(1, '\0'), std::string(100'000, '\0'),
        std::string(1000, '\xff')}) {
    SCOPED_TRACE(wrong.substr(0, 100));
    testing::put(folder_ / "x.costs", wrong);
    expect_refused(walk("costs=x.costs"), "x.costs:");
    expect_refused(table("costs=x.costs"), "x.costs:");
  }
  std::filesystem::remove(folder_ / "x.costs");
  expect_refused(walk("costs=x.costs"), "x.costs:");
  std::filesystem::create_directory(folder_ / "x.costs");
  expect_refused(table("costs=x.costs"), "x.costs:");
  EXPECT_EQ(files(), (std::vector<std::string>{"a.obj", "x.costs"})) << "nothing was written";
}

/// What costs nothing, or as much as a file may say, is chosen for like anything else.
TEST_F(WrongCosts, TheLeastAndTheMostGiveNumbers) {
  const std::regex none("nan|inf|null", std::regex::icase);
  for (const std::string& odd : {costs("0 0 0", "frame 0"), costs("1e9 1e9 1e9", "frame 1e9"), costs("1e-300 0 0")}) {
    testing::put(folder_ / "x.costs", odd);
    for (const char* budget : {"0.0001", "1000000"}) {
      const testing::Ended walked = walk("costs=x.costs, budget=" + std::string(budget));
      EXPECT_EQ(walked.code, 0) << walked.err;
      EXPECT_FALSE(std::regex_search(walked.out, none)) << walked.out;
    }
    const testing::Ended made = table("costs=x.costs");
    EXPECT_EQ(made.code, 0) << made.err;
  }
}
#endif

}  // namespace
}  // namespace foredraw::wrong_costs_test
