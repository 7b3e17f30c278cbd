#include <foredraw/analysis/overdraw_figures.h>

#include "support/painter.h"

#include <foredraw/analysis/view_sphere.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw {
namespace {

using testing::part_of;
using testing::TestMesh;

TEST(OverdrawFigures, ratio_and_mean_of_views) {
  const std::vector<OverdrawCount> counts = {{30, 10, 0}, {10, 10, 0}, {5, 0, 0}, {20, 20, 0}};
  const std::vector<View> views(4);
  const Estimate ratio = overdraw_ratio(counts, views);
  EXPECT_EQ(ratio.numerator, 65);
  EXPECT_EQ(ratio.denominator, 40);
  // Deviations from 1.625 times visible: 13.75, -6.25, 5, -12.5.
  EXPECT_NEAR(ratio.error, std::sqrt((13.75 * 13.75 + 6.25 * 6.25 + 25 + 12.5 * 12.5) / 12) / 10, 1e-12);
  const Estimate mean = overdraw_view_mean(counts, views);
  EXPECT_EQ(mean.numerator, 5);  // 3 + 1 + 1
  EXPECT_EQ(mean.denominator, 3);
  EXPECT_NEAR(mean.error, 2.0 / 3, 1e-12);
}

TEST(OverdrawFigures, the_error_is_what_samples_of_views_scatter_by) {
  const TestMesh mesh = testing::joined(testing::torus(24, 12), testing::sphere(16, 8, 0.8f, {0, 0.5f, 0}));
  std::vector<double> ratios;
  double claimed = 0;
  constexpr int samples = 200;
  for (int seed = 0; seed < samples; ++seed) {
    ViewSet set;
    set.views = "random";
    set.count = 30;
    set.seed = seed;
    set.size = 32;
    const RasterPart part = part_of(mesh);
    const Views views = make_views(set);
    const Estimate ratio = overdraw_ratio(
        testing::painted({&part, 1}, views, testing::rising_order(mesh.indices.size() / 3)), views.views);
    ratios.push_back(ratio.numerator / ratio.denominator);
    claimed += ratio.error / samples;
  }
  double mean = 0;
  for (const double ratio : ratios) mean += ratio / samples;
  double variance = 0;
  for (const double ratio : ratios) variance += (ratio - mean) * (ratio - mean) / (samples - 1);
  EXPECT_NEAR(claimed / std::sqrt(variance), 1, 0.15);
}

TEST(OverdrawFigures, one_view_or_none_has_no_error) {
  const std::vector<View> views(1);
  EXPECT_EQ(overdraw_ratio({}, {}).error, 0);
  EXPECT_EQ(overdraw_view_mean({}, {}).denominator, 0);
  const OverdrawCount count{3, 2, 0};
  EXPECT_EQ(overdraw_ratio({&count, 1}, views).error, 0);
  EXPECT_EQ(overdraw_view_mean({&count, 1}, views).numerator, 1.5);
}

TEST(OverdrawFigures, a_view_of_weight_two_counts_as_two_views) {
  const std::vector<OverdrawCount> counts = {{30, 10, 0}, {10, 10, 0}};
  const std::vector<OverdrawCount> repeated = {{30, 10, 0}, {10, 10, 0}, {10, 10, 0}};
  std::vector<View> views(2);
  views[1].weight = 2;
  const std::vector<View> alike(3);
  EXPECT_EQ(overdraw_ratio(counts, views).numerator, overdraw_ratio(repeated, alike).numerator);
  EXPECT_EQ(overdraw_ratio(counts, views).denominator, overdraw_ratio(repeated, alike).denominator);
  EXPECT_EQ(overdraw_view_mean(counts, views).numerator, overdraw_view_mean(repeated, alike).numerator);
  EXPECT_EQ(overdraw_view_mean(counts, views).denominator, overdraw_view_mean(repeated, alike).denominator);
}

TEST(OverdrawFigures, an_error_does_not_depend_on_the_scale_of_the_weights) {
  const std::vector<OverdrawCount> counts = {{30, 10, 0}, {10, 10, 0}, {15, 12, 0}};
  const std::vector<View> views(3);
  std::vector<View> heavy(3);
  for (View& view : heavy) view.weight = 8;
  EXPECT_EQ(overdraw_ratio(counts, views).error, overdraw_ratio(counts, heavy).error);
  EXPECT_EQ(overdraw_view_mean(counts, views).error, overdraw_view_mean(counts, heavy).error);
}

TEST(OverdrawFigures, several_rounds_of_views_take_the_weights_in_turn) {
  const std::vector<OverdrawCount> counts = {{3, 1, 0}, {1, 1, 0}, {5, 1, 0}, {1, 1, 0}};
  std::vector<View> views(2);
  views[0].weight = 3;
  EXPECT_EQ(overdraw_ratio(counts, views).numerator, 3 * 3 + 1 + 3 * 5 + 1);
  EXPECT_EQ(overdraw_view_mean(counts, views).denominator, 8);
}

TEST(OverdrawFigures, the_worst_picture_is_the_first_with_the_highest_ratio) {
  const std::vector<OverdrawCount> counts = {{5, 0, 0}, {10, 10, 0}, {6, 3, 0}, {2, 1, 0}};
  EXPECT_EQ(worst_picture(counts), 2u);
  EXPECT_FALSE(worst_picture({&counts[0], 1}));
  EXPECT_FALSE(worst_picture({}));
}

}  // namespace
}  // namespace foredraw
