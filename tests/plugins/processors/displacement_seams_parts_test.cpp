#include "plugins/processors/displacement_seams/equal_heights.h"
#include "plugins/processors/displacement_seams/equal_integers.h"
#include "plugins/processors/displacement_seams/sparse_symmetric.h"

#include "support/uv_charts.h"

#include <gtest/gtest.h>

#include <numeric>

namespace foredraw::processors::displacement_seams::displacement_seams_parts_test {
namespace {

using testing::Map;

using Dense = std::vector<std::vector<double>>;

SymmetricMatrix sparse(const Dense& dense) {
  SymmetricMatrix matrix;
  matrix.starts.push_back(0);
  for (std::size_t r = 0; r < dense.size(); ++r) {
    for (std::uint32_t c = 0; c < dense.size(); ++c) {
      if (dense[r][c] == 0 && r != c) continue;
      matrix.columns.push_back(c);
      matrix.values.push_back(dense[r][c]);
    }
    matrix.starts.push_back(matrix.columns.size());
  }
  return matrix;
}

/// By Gauss with pivots.
std::vector<double> eliminated(Dense a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k; r < n; ++r) pivot = std::abs(a[r][k]) > std::abs(a[pivot][k]) ? r : pivot;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t r = k + 1; r < n; ++r) {
      const double part = a[r][k] / a[k][k];
      for (std::size_t c = k; c < n; ++c) a[r][c] -= part * a[k][c];
      b[r] -= part * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < n; ++c) b[k] -= a[k][c] * b[c];
    b[k] /= a[k][k];
  }
  return b;
}

TEST(LdltFactor, SolvesAsGaussDoes) {
  Random random(1);
  for (const std::size_t n : {0u, 1u, 2u, 7u, 40u, 120u}) {
    Dense matrix(n, std::vector<double>(n, 0));
    for (std::size_t k = 0; k < n; ++k) matrix[k][k] = 1;
    for (std::size_t row = 0; row < 2 * n; ++row) {  // the identity, and squares of rows of a few entries
      std::array<std::size_t, 4> at;
      std::array<double, 4> weight;
      for (int i = 0; i < 4; ++i) {
        at[i] = random.below(n);
        weight[i] = 100 * (random.unit() - 0.5);
      }
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) matrix[at[i]][at[j]] += weight[i] * weight[j];
      }
    }
    std::vector<double> right(n);
    for (double& value : right) value = random.unit();
    const SymmetricMatrix of(sparse(matrix));
    const std::vector<std::uint32_t> order = minimum_degree(of);
    LdltFactor factor(of, order);
    factor.compute();
    std::vector<double> solution = right;
    factor.solve(solution);
    const std::vector<double> wanted = eliminated(matrix, right);
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(solution[k], wanted[k], 1e-9) << n;
  }
}

/// Of a grid of n x n rows, each joined with four others.
SymmetricMatrix grid_matrix(std::uint32_t n) {
  SymmetricMatrix matrix;
  matrix.starts.push_back(0);
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const auto add = [&](std::uint32_t column, double value) {
        matrix.columns.push_back(column);
        matrix.values.push_back(value);
      };
      if (y > 0) add((y - 1) * n + x, -1);
      if (x > 0) add(y * n + x - 1, -1);
      add(y * n + x, 5);
      if (x + 1 < n) add(y * n + x + 1, -1);
      if (y + 1 < n) add((y + 1) * n + x, -1);
      matrix.starts.push_back(matrix.columns.size());
    }
  }
  return matrix;
}

TEST(MinimumDegree, HoldsEveryRowOnceAndLeavesFewEntries) {
  const SymmetricMatrix grid = grid_matrix(60);
  std::vector<std::uint32_t> order = minimum_degree(grid), natural(grid.size());
  std::iota(natural.begin(), natural.end(), 0u);
  const LdltFactor ordered(grid, order), as_it_is(grid, natural);
  EXPECT_LT(ordered.entries(), as_it_is.entries() / 3);
  std::ranges::sort(order);
  EXPECT_EQ(order, natural);
}

TEST(MinimumDegree, EndsWhenItIsCancelled) {
  const std::atomic<bool> cancel = true;
  EXPECT_LT(minimum_degree(grid_matrix(60), &cancel).size(), 3600u);
}

TEST(RowsAlongSeams, SayTheMeanSquareOfTheGap) {
  const testing::Charts charts = testing::cube_sphere(3, testing::turned_places());
  const Map map = testing::noise_map(96, 128, 3);
  const SeamEdges seams = charts.seams();
  double rows = 0;
  for (const EqualityRow& row : rows_along_seams(seams, map.view())) {
    double gap = 0;
    for (std::uint32_t i = 0; i < row.count; ++i) gap += row.weights[i] * map.texels[row.texels[i]];
    rows += gap * gap;
  }
  double sampled = 0;
  constexpr int samples = 20000;
  for (const auto& [ends, sides] : testing::edges_of(charts.mesh())) {
    if (sides[0] == sides[1]) continue;
    const double length = std::max(testing::texel_length(sides[0], map), testing::texel_length(sides[1], map));
    for (int k = 0; k < samples; ++k) {
      std::array<double, 2> height;
      for (int s = 0; s < 2; ++s) {
        const glm::dvec2 from(sides[s][0]), to(sides[s][1]);
        const glm::dvec2 at = (from + (to - from) * ((k + 0.5) / samples)) * glm::dvec2(map.width, map.height);
        height[s] = testing::height_of(map, at.x, at.y);
      }
      sampled += length / samples * (height[0] - height[1]) * (height[0] - height[1]);
    }
  }
  EXPECT_NEAR(rows / sampled, 1, 1e-4);
}

/// The gap is 0 where the mean square of all rows is least, and no change is larger than it has to be.
TEST(EqualHeights, ChangeAsLittleAsMayBe) {
  EqualityRow one;
  one.count = 2;
  one.texels = {0, 1};
  one.weights = {1, -1};
  const std::vector<double> texels{10, 30, 77};
  const auto heights = equal_heights(texels, {}, {one});
  EXPECT_NEAR(heights[0], 20, 1e-6);
  EXPECT_NEAR(heights[1], 20, 1e-6);
  EXPECT_EQ(heights[2], 77);
  const auto without = equal_heights(texels, {one}, {}, {.most_multiplications = 0});
  EXPECT_EQ(without, texels) << "rows along seams are left out where they cost too much";
}

TEST(EqualHeights, HaveNoGapAtPoints) {
  const testing::Charts charts = testing::cube_sphere(4, testing::turned_places());
  const Map map = testing::noise_map(128, 128, 5);
  const SeamEdges seams = charts.seams();
  const SeamPoints points = seam_points(seams, seam_factors(seams, {128, 128}), map.view());
  std::vector<EqualityRow> at_points = rows_of_points(points, map.view());
  std::vector<EqualityRow> along = rows_along_seams(seams, map.view());
  const std::vector<std::uint32_t> numbers = numbered(along, at_points);
  std::vector<double> texels;
  for (const std::uint32_t place : numbers) texels.push_back(map.texels[place]);
  const auto heights = equal_heights(texels, along, at_points);
  for (const EqualityRow& row : at_points) {
    double gap = 0;
    for (std::uint32_t i = 0; i < row.count; ++i) gap += row.weights[i] * heights[row.texels[i]];
    EXPECT_LT(std::abs(gap), 2) << "of 65535";
  }
}

TEST(IntegerHeights, SettleByFewSingleStepsAndLetGoOfWhatIsReleased) {
  const testing::Charts charts = testing::cube_sphere(4, testing::turned_places());
  Map map = testing::noise_map(128, 128, 6);
  for (std::uint16_t& texel : map.texels) texel = static_cast<std::uint16_t>(30000 + texel % 40);
  const SeamEdges seams = charts.seams();
  const SeamPoints points = seam_points(seams, seam_factors(seams, {128, 128}), map.view());
  std::vector<std::uint32_t> all(map.texels.size());
  std::iota(all.begin(), all.end(), 0u);
  IntegerHeights heights(points, map.view(), all, map.texels, 14);
  const std::vector<bool> is_unequal = unequal_points(points, map.view(), 14);
  EXPECT_GT(heights.unequal_count(), 50u);
  EXPECT_EQ(heights.unequal_count(), static_cast<std::size_t>(std::ranges::count(is_unequal, true)));
  const std::size_t before = heights.unequal_count();
  const auto first = static_cast<std::size_t>(std::ranges::find(is_unequal, true) - is_unequal.begin());
  heights.release(first);
  EXPECT_EQ(heights.unequal_count(), before - 1);
  EXPECT_FALSE(heights.is_unequal(first));
  heights.settle(100);
  EXPECT_EQ(heights.unequal_count(), 0u);
  for (std::size_t i = 0; i < map.texels.size(); ++i) EXPECT_NEAR(heights.values()[i], map.texels[i], 400);
}

}  // namespace
}  // namespace foredraw::processors::displacement_seams::displacement_seams_parts_test
