#include "plugins/processors/levels/levels.h"

#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace foredraw::levels_goals_test {
namespace {

using ::testing::HasSubstr;

std::string refusal(const Settings& settings) {
  try {
    levels_plugin().create(settings);
  } catch (const std::invalid_argument& mistake) {
    return mistake.what();
  }
  return "taken";
}

TEST(LevelGoals, AreRefusedWhereTheyMakeNoSense) {
  EXPECT_EQ(refusal({{"ratios", "0.5"}}), "taken");
  EXPECT_EQ(refusal({{"ratios", " 0.5 ,0.25 "}}), "taken");
  EXPECT_EQ(refusal({{"errors", "0, 1e-3"}}), "taken");
  for (const char* ratios : {"0", "1", "1.5", "-0.1", "0.5, 0"}) {
    EXPECT_THAT(refusal({{"ratios", ratios}}), HasSubstr("above 0 and below 1")) << ratios;
  }
  for (const char* ratios : {"0.25, 0.5", "0.5, 0.5"}) {
    EXPECT_THAT(refusal({{"ratios", ratios}}), HasSubstr("must fall")) << ratios;
  }
  EXPECT_THAT(refusal({{"ratios", ""}}), HasSubstr("at least one"));
  EXPECT_THAT(refusal({{"errors", "-1"}}), HasSubstr("a distance"));
  EXPECT_THAT(refusal({{"errors", "2, 1"}}), HasSubstr("must rise"));
  for (const char* distances : {"0", "-1", "20, 10", "5, 5"}) {
    EXPECT_THAT(refusal({{"distances", distances}}), HasSubstr("above 0 and rise")) << distances;
  }
  EXPECT_THAT(refusal({{"distances", "10"}, {"errors", "1"}}), HasSubstr("not both"));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const LevelGoals& goals : {LevelGoals{{0.5}, {0.5}}, LevelGoals{{nan}, {}}, LevelGoals{{0.5, nan}, {}},
                                  LevelGoals{{}, {nan}}, LevelGoals{{}, {infinity}}, LevelGoals{{}, {1, nan}}}) {
    EXPECT_THROW(check(goals), std::invalid_argument);
  }
}

}  // namespace
}  // namespace foredraw::levels_goals_test
