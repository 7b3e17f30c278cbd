#include <foredraw/base/random.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <set>

namespace foredraw::random_test {
namespace {

TEST(Random, IsSplitMix64AsPublished) {
  // The reference implementation's first numbers for seed 1234567.
  Random random(1234567);
  for (const std::uint64_t expected : {6457827717110365317ull, 3203168211198807973ull, 9817491932198370423ull,
                                       4593380528125082431ull, 16408922859458223821ull}) {
    EXPECT_EQ(random.next(), expected);
  }
}

TEST(Random, UnitStaysBelowOneAndFillsTheRange) {
  Random random(1);
  double sum = 0, least = 1, most = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double value = random.unit();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_NEAR(sum / count, 0.5, 0.005);  // five standard deviations
  EXPECT_LT(least, 0.001);
  EXPECT_GT(most, 0.999);
}

TEST(Random, BelowStaysBelow) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed, std::uint64_t bound) {
    RC_PRE(bound > 0);
    RC_ASSERT(Random(seed).below(bound) < bound);
  }));
  EXPECT_EQ(Random(5).below(1), 0u);
  EXPECT_LT(Random(5).below(~std::uint64_t{0}), ~std::uint64_t{0});
}

TEST(Random, BelowIsEven) {
  Random random(9);
  std::array<int, 6> counts{};
  for (int i = 0; i < 60000; ++i) ++counts[random.below(6)];
  for (const int count : counts) EXPECT_NEAR(count, 10000, 460);  // five standard deviations
}

TEST(DeriveSeed, EveryStageAndDrawHasItsOwn) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (std::uint64_t stage = 0; stage < 30; ++stage) {
      for (std::uint64_t draw = 0; draw < 300; ++draw) seeds.insert(derive_seed(seed, stage, draw));
    }
  }
  EXPECT_EQ(seeds.size(), 10u * 30 * 300);
  EXPECT_EQ(derive_seed(1, 2, 3), derive_seed(1, 2, 3));
}

}  // namespace
}  // namespace foredraw::random_test
