// What is done with a double-sided draw follows from figures alone.

#include "plugins/processors/sides/side_choices.h"

#include <gtest/gtest.h>

namespace foredraw {
namespace {

using sides::Choice, sides::Counted;
using Choices = std::map<DrawId, Choice>;

TEST(SidesChoices, CountsWhatIsSeen) {
  const sides::Side wanted[] = {sides::front, sides::both, sides::back, sides::both, sides::front};
  const Counted count = sides::counted(wanted);
  EXPECT_EQ(count.triangles, 5u);
  EXPECT_EQ(count.added, 2u);
  EXPECT_EQ(count.turned, 1u);
  EXPECT_EQ(count.backs(), 3u);
}

TEST(SidesChoices, WhereNoBackIsSeenNothingIsAdded) {
  EXPECT_EQ(sides::first_choices({{3, {100, 0, 0}}}, 100, {.most_added = 0}), (Choices{{3, Choice::single_sided}}));
}

TEST(SidesChoices, DrawsThatAddLeastComeFirst) {
  const std::map<DrawId, Counted> counts{{0, {100, 15, 0}}, {1, {100, 10, 0}}, {2, {100, 4, 9}}};
  EXPECT_EQ(sides::first_choices(counts, 300, {.most_added = 0.05}),
            (Choices{{0, Choice::two_draws}, {1, Choice::copies}, {2, Choice::copies}}))
      << "4 and 10 of the 15 that are allowed";
  EXPECT_EQ(sides::first_choices(counts, 300, {.most_added = 0.05, .split = false}).at(0), Choice::left);
}

TEST(SidesChoices, TurnedTrianglesCostNothing) {
  EXPECT_EQ(sides::first_choices({{0, {100, 0, 100}}}, 100, {.most_added = 0}).at(0), Choice::copies);
}

/// A sail: copies of all of it would only take what other draws could have.
TEST(SidesChoices, SheetsAreNotCopied) {
  const std::map<DrawId, Counted> counts{{0, {100, 95, 0}}, {1, {1000, 150, 0}}, {2, {50, 50, 0}}};
  EXPECT_EQ(sides::first_choices(counts, 1150, {.most_added = 0.2}),
            (Choices{{0, Choice::two_draws}, {1, Choice::copies}, {2, Choice::left}}));
}

TEST(SidesChoices, PayWhereTheySaveMoreThanTheyCost) {
  const Counted count{1000, 100, 0};
  // 100 triangles of .7 vertices, each a tenth of a fragment, in a scene of 700: a hundredth of what is seen.
  EXPECT_TRUE(sides::pays(Choice::copies, count, 101, 10000, 700, {}));
  EXPECT_FALSE(sides::pays(Choice::copies, count, 99, 10000, 700, {}));
  EXPECT_TRUE(sides::pays(Choice::copies, count, 99, 10000, 700, {.vertex_weight = 0.01}));
  EXPECT_FALSE(sides::pays(Choice::copies, count, 0, 10000, 700, {.vertex_weight = 0}));
  EXPECT_TRUE(sides::pays(Choice::two_draws, count, 101, 10000, 700, {}));
  EXPECT_FALSE(sides::pays(Choice::two_draws, count, 99, 10000, 700, {}));
  EXPECT_TRUE(sides::pays(Choice::single_sided, count, 0, 10000, 700, {}));
}

}  // namespace
}  // namespace foredraw
