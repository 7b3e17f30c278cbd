// foredraw check-module: what authors are told.
#include "left_behind.h"
#include "support/program.h"

#include <gmock/gmock.h>

namespace foredraw::testing::check_module_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class CheckModule : public InFolder {
 protected:
  Ended checked(const std::string& name) {
    return run_program(folder_, "check-module '" + module_in(folder_, name) + "' --threads 3");
  }
};

TEST_F(CheckModule, ShowsWhatATechniqueTakesAndGains) {
  const Ended ended = checked("radial");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("acme 1.0.0"));
  EXPECT_THAT(ended.out, HasSubstr("acme-radial (orderer)"));
  EXPECT_THAT(ended.out, HasSubstr("right on 12 odd draws at 3 settings of its options"));
  EXPECT_THAT(ended.out, HasSubstr("the same twice, and on 1 and "));
  EXPECT_THAT(ended.out, HasSubstr("acmr after"));
}

TEST_F(CheckModule, FailsWhereAnAnswerIsWrong) {
  const Ended ended = checked("twin");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.out, HasSubstr("FAILED hostile-twin"));
  EXPECT_THAT(ended.out, HasSubstr("is not a permutation"));
  EXPECT_THAT(workers_left(folder_), ::testing::IsEmpty());
}

TEST_F(CheckModule, FailsWhereAnswersDifferFromTimeToTime) {
  const Ended ended = checked("changes");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.out, HasSubstr("FAILED it answers otherwise at the second time"));
}

TEST_F(CheckModule, FailsWhereThereIsNoModule) {
  const Ended ended = checked("no-module");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("exports no function"));
}

}  // namespace
}  // namespace foredraw::testing::check_module_test
