#include <foredraw/frames/non_negative_least_squares.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::non_negative_least_squares_test {
namespace {

struct Equations {
  std::vector<double> rows, wanted;
  std::size_t unknowns = 0;

  std::vector<double> solution() const { return non_negative_least_squares(rows, wanted, unknowns); }
  std::vector<double> left(const std::vector<double>& x) const {
    std::vector<double> left = wanted;
    for (std::size_t r = 0; r < wanted.size(); ++r) {
      for (std::size_t c = 0; c < unknowns; ++c) left[r] -= rows[r * unknowns + c] * x[c];
    }
    return left;
  }
};

double between(Random& random, double least, double most) { return least + (most - least) * random.unit(); }

Equations random_equations(std::uint64_t seed, std::size_t count, std::size_t unknowns) {
  Random random(seed);
  Equations made;
  made.unknowns = unknowns;
  for (std::size_t i = 0; i < count * unknowns; ++i) made.rows.push_back(between(random, -1, 1));
  for (std::size_t i = 0; i < count; ++i) made.wanted.push_back(between(random, -1, 1));
  return made;
}

/// Of the least sum that there is (Karush, Kuhn, Tucker): nothing is below 0, along what is above 0 the sum is level,
/// along the others it rises.
TEST(NonNegativeLeastSquares, NothingComesNearer) {
  std::size_t zeros = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::size_t unknowns = 1 + seed % 11;
    const Equations equations = random_equations(seed, 1 + seed % 23, unknowns);
    const std::vector<double> x = equations.solution();
    const std::vector<double> left = equations.left(x);
    for (std::size_t c = 0; c < unknowns; ++c) {
      double slope = 0;
      for (std::size_t r = 0; r < left.size(); ++r) slope += equations.rows[r * unknowns + c] * left[r];
      EXPECT_GE(x[c], 0);
      EXPECT_LT(slope, 1e-9) << seed;
      EXPECT_NEAR(x[c] > 0 ? slope : 0, 0, 1e-9) << seed;
      ++(x[c] > 0 ? others : zeros);
    }
  }
  EXPECT_GT(zeros, 400u);
  EXPECT_GT(others, 400u);
}

TEST(NonNegativeLeastSquares, FindsWhatAnswersExactly) {
  Equations equations = random_equations(5, 40, 8);
  const std::vector<double> wanted = {3, 0, 1e-3, 7, 0, 2e4, 1, 0.5};
  for (std::size_t r = 0; r < 40; ++r) {
    equations.wanted[r] = 0;
    for (std::size_t c = 0; c < 8; ++c) equations.wanted[r] += equations.rows[r * 8 + c] * wanted[c];
  }
  const std::vector<double> x = equations.solution();
  for (std::size_t c = 0; c < 8; ++c) EXPECT_NEAR(x[c], wanted[c], 1e-9 * 2e4);
}

/// Numbers of triangles and numbers of pixels differ by orders of magnitude.
TEST(NonNegativeLeastSquares, UnitsOfColumnsDoNotMatter) {
  Equations equations = random_equations(6, 30, 3);
  for (double& each : equations.rows) each = std::abs(each);
  for (std::size_t r = 0; r < 30; ++r) {
    double* row = equations.rows.data() + 3 * r;
    row[0] *= 1e12, row[2] *= 1e-9;
    equations.wanted[r] = 1e-12 * row[0] + 2 * row[1] + 3e9 * row[2];
  }
  const std::vector<double> x = equations.solution();
  EXPECT_NEAR(x[0] * 1e12, 1, 1e-9);
  EXPECT_NEAR(x[1], 2, 1e-9);
  EXPECT_NEAR(x[2] * 1e-9, 3, 1e-9);
}

TEST(NonNegativeLeastSquares, WhatIsNotToldApartGoesToTheFirst) {
  const Equations alike{{1, 1, 0, 2, 2, 0}, {1, 2}, 3};
  EXPECT_EQ(alike.solution()[1], 0);
  EXPECT_EQ(alike.solution()[2], 0) << "no row has it";
  EXPECT_NEAR(alike.solution()[0], 1, 1e-15);
  // The third is the sum of the others.
  const Equations sum{{1, 0, 1, 0, 1, 1, 1, 1, 2, 1, 2, 3}, {1, 2, 3, 5}, 3};
  for (const double left : sum.left(sum.solution())) EXPECT_NEAR(left, 0, 1e-12);
}

TEST(NonNegativeLeastSquares, OfNothingAreZeros) {
  EXPECT_EQ(non_negative_least_squares({}, {}, 3), std::vector<double>(3, 0.0));
  EXPECT_TRUE(non_negative_least_squares({}, std::vector<double>{1, 2}, 0).empty());
  EXPECT_EQ(non_negative_least_squares(std::vector<double>{0, 0}, std::vector<double>{1}, 2),
            std::vector<double>(2, 0.0));
  EXPECT_EQ(non_negative_least_squares(std::vector<double>{1, 2}, std::vector<double>{-1}, 2),
            std::vector<double>(2, 0.0))
      << "every step makes it worse";
}

}  // namespace
}  // namespace foredraw::non_negative_least_squares_test
