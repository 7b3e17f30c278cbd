// The example engine walks through a city at a budget.

#include "support/program.h"

#include <regex>

namespace foredraw {
namespace {

class BudgetWalk : public testing::InFolder {
 protected:
  /// Of each line: milliseconds, whether they are the least there can be, and the part of the best that is shown.
  struct Frame {
    double milliseconds = 0;
    bool is_least = false;
    double part = 0;
  };

  std::vector<Frame> walk(const std::string& arguments) {
    const std::string out = (folder_ / "out").string();
    const std::string command = std::string("'") + FOREDRAW_BUDGET_WALK + "' " + arguments + " > '" + out + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::regex line(R"(frame +\d+: +\d+ visible, +([\d.]+) ms( \(the least\))?, ([\d.]+) of the best .*)");
    std::vector<Frame> frames;
    std::istringstream lines(testing::content(out));
    for (std::string text; std::getline(lines, text);) {
      std::smatch at;
      EXPECT_TRUE(std::regex_match(text, at, line)) << text;
      frames.push_back({std::stod(at[1]), at[2].matched, std::stod(at[3])});
    }
    return frames;
  }
};

TEST_F(BudgetWalk, KeepsItsBudgetAndShowsNearlyTheBest) {
  for (const double budget : {2.5, 4.0, 12.0}) {
    const std::vector<Frame> frames = walk(std::to_string(budget) + " 40");
    EXPECT_GE(frames.size(), 6u);
    for (const Frame& frame : frames) {
      EXPECT_TRUE(frame.is_least || frame.milliseconds <= budget + 0.005);
      EXPECT_GE(frame.part, 0.995);
    }
  }
}

/// The least of each object is drawn, none is left out.
TEST_F(BudgetWalk, DrawsTheLeastWhereNothingIsCheapEnough) {
  for (const Frame& frame : walk("0 20")) {
    EXPECT_TRUE(frame.is_least);
    EXPECT_GT(frame.milliseconds, 0.5);
  }
}

}  // namespace
}  // namespace foredraw
