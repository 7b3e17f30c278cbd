#include <foredraw/analysis/sampled.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::sampled_test {
namespace {

std::vector<double> even(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(count);
  for (double& value : values) value = random.unit();
  return values;
}

TEST(Sampled, OfFewValues) {
  const std::vector<double> values{1, 2, 3, 6};
  EXPECT_DOUBLE_EQ(mean_of(values).value, 3);
  EXPECT_DOUBLE_EQ(mean_of(values).error, std::sqrt(14.0 / 12));
  EXPECT_DOUBLE_EQ(rms_of(values).value, std::sqrt(12.5));
  EXPECT_EQ(quantile_of(values, 0.5).value, 2);
  EXPECT_EQ(quantile_of(values, 1).value, 6);
  EXPECT_EQ(quantile_of(values, 0).value, 1);
  EXPECT_EQ(mean_of({}).value, 0);
  EXPECT_EQ(quantile_of({}, 0.5).value, 0);
  EXPECT_EQ(mean_of(std::vector<double>{4}).error, 0);
}

/// Three errors hold the truth 997 times in 1,000.
TEST(Sampled, ErrorsAreNotTooSmall) {
  int outside = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<double> values = even(2000, seed);
    const Sampled mean = mean_of(values), rms = rms_of(values), p99 = quantile_of(values, 0.99);
    outside += std::abs(mean.value - 0.5) > 3 * mean.error;
    outside += std::abs(rms.value - std::sqrt(1.0 / 3)) > 3 * rms.error;
    outside += std::abs(p99.value - 0.99) > 3 * p99.error;
  }
  EXPECT_LE(outside, 6);
}

TEST(Sampled, OfBothWeighsThemAlike) {
  const Sampled mean = mean_of_both({1, 0.3}, {3, 0.4}), rms = rms_of_both({3, 0}, {4, 0.1});
  EXPECT_DOUBLE_EQ(mean.value, 2);
  EXPECT_DOUBLE_EQ(mean.error, 0.25);
  EXPECT_DOUBLE_EQ(rms.value, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(rms.error, 0.4 / (2 * std::sqrt(12.5)));
  EXPECT_EQ(rms_of_both({}, {}).error, 0);
}

}  // namespace
}  // namespace foredraw::sampled_test
