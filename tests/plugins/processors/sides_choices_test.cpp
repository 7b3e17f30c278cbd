// What is done with a double-sided draw follows from figures alone.

#include "plugins/processors/sides/side_choices.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::sides_choices_test {
namespace {

using processors::sides::Choice, processors::sides::Plan, processors::sides::Side, processors::sides::Sided;
using processors::sides::front, processors::sides::back, processors::sides::both;

/// Prices of a triangle and of a draw call, in fragments, where nothing else is said.
Plan plan(const std::vector<Side>& wanted, const std::vector<double>& gains, double price = 1, double call = 10,
          bool may_split = true) {
  return processors::sides::cheapest_plan({wanted, gains, 0}, price, call, may_split);
}

TEST(SidesChoices, WhereNoBackIsSeenNothingIsAdded) {
  const Plan one = plan({front, front}, {0, 0}, 1e9);
  EXPECT_EQ(one.choice, Choice::single_sided);
  EXPECT_EQ(one.added, 0u);
}

TEST(SidesChoices, CopiesMustGainMoreThanTheyCost) {
  EXPECT_EQ(plan({both, front}, {1.5, 0}).choice, Choice::copies);
  EXPECT_EQ(plan({both, front}, {0, 1.5}).choice, Choice::copies) << "whose back is not drawn any more, gains too";
  EXPECT_EQ(plan({both, front}, {0.5, 0.4}).choice, Choice::left);
  EXPECT_EQ(plan({both, front}, {1.5, 0}).added, 1u);
}

TEST(SidesChoices, TurnedTrianglesCostNothing) {
  EXPECT_EQ(plan({back, back}, {0.1, 0}, 1e9).choice, Choice::copies);
  EXPECT_EQ(plan({back, back}, {0.1, 0}, 1e9).added, 0u);
}

/// Some triangles gain much; copies of the many others cost more than a draw call.
TEST(SidesChoices, WhatGainsLittleStaysDoubleSidedInADrawOfItsOwn) {
  std::vector<Side> wanted(100, both);
  std::vector<double> gains(100, 0.1);
  wanted[0] = front;
  gains[3] = gains[7] = 50;
  const Plan two = plan(wanted, gains);
  EXPECT_EQ(two.choice, Choice::two_draws);
  EXPECT_EQ(two.added, 2u);
  EXPECT_EQ(std::ranges::count(two.stays, true), 97);
  EXPECT_FALSE(two.stays[0] || two.stays[3] || two.stays[7]);
  EXPECT_NEAR(two.saved, 100.1, 1e-9);
  EXPECT_EQ(plan(wanted, gains, 1, 10, false).choice, Choice::copies) << "99 triangles cost less than 109.8 fragments";
  EXPECT_EQ(plan(wanted, gains, 1, 1000).choice, Choice::copies);
  EXPECT_EQ(plan(wanted, gains, 2, 1000).choice, Choice::left);
}

/// A sail gains next to nothing: it takes nothing from what other draws may add.
TEST(SidesChoices, TheScenesTrianglesGoWhereTheyGainMost) {
  const std::vector<Side> all(100, both);
  std::vector<double> sail(100, 0.5), hull(100), hose(100);
  for (std::size_t t = 0; t < 100; ++t) {
    hull[t] = static_cast<double>(t);
    hose[t] = 200;
  }
  const std::map<DrawId, Sided> draws{{0, {all, sail, 70}}, {1, {all, hull, 70}}, {2, {all, hose, 70}}};
  const processors::sides::Sizes scene{
      .triangles = 1000, .vertices = 700, .visible = 10'000};  // a triangle costs one fragment
  const auto added = [&](double most) {
    std::vector<std::size_t> result;
    for (const auto& [id, plan] : processors::sides::plans(draws, scene, {.most_added = most, .vertex_weight = 0.1}))
      result.push_back(plan.added);
    return result;
  };
  EXPECT_EQ(added(1), (std::vector<std::size_t>{0, 100, 100})) << "a call would cost more than copies of all the hull";
  EXPECT_EQ(added(0.15), (std::vector<std::size_t>{0, 50, 100}));
  EXPECT_EQ(added(0.1), (std::vector<std::size_t>{0, 0, 100}));
  EXPECT_EQ(added(0.05), (std::vector<std::size_t>{0, 0, 0}));
  const auto plans = processors::sides::plans(draws, scene, {.most_added = 0.15, .vertex_weight = 0.1});
  EXPECT_FALSE(plans.at(1).stays[99]);
  EXPECT_TRUE(plans.at(1).stays[0]);
  EXPECT_EQ(
      processors::sides::plans(draws, scene, {.most_added = 0.15, .vertex_weight = 0.1, .split = false}).at(1).choice,
      Choice::left);
}

TEST(SidesChoices, VerticesHaveTheWeightThatTheyAreGiven) {
  const std::vector<Side> wanted{both, front};
  const std::vector<double> gains{1, 0};
  const std::map<DrawId, Sided> draws{{0, {wanted, gains, 1.4}}};
  const processors::sides::Sizes scene{.triangles = 2, .vertices = 7, .visible = 90};
  const auto choice = [&](double weight) {
    return processors::sides::plans(draws, scene, {.most_added = 1, .vertex_weight = weight}).at(0).choice;
  };
  EXPECT_EQ(choice(0.1), Choice::copies);  // .9 fragments
  EXPECT_EQ(choice(0.2), Choice::left);
}

}  // namespace
}  // namespace foredraw::sides_choices_test
