#include <foredraw/overdraw/overdraw_figures.h>

#include "support/painter.h"

#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::overdraw_figures_test {
namespace {

using testing::part_of;
using testing::TestMesh;

std::vector<ViewTally> tallies(const std::vector<OverdrawCount>& counts) {
  std::vector<ViewTally> made(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) made[i].add(counts[i]);
  return made;
}

TEST(OverdrawFigures, ratio_and_mean_of_views) {
  const std::vector<ViewTally> counts = tallies({{30, 10, 0}, {10, 10, 0}, {5, 0, 0}, {20, 20, 0}});
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
        tallies(testing::painted({&part, 1}, views, testing::rising_order(mesh.indices.size() / 3))), views.views);
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
  const ViewTally count = tallies({{3, 2, 0}})[0];
  EXPECT_EQ(overdraw_ratio({&count, 1}, views).error, 0);
  EXPECT_EQ(overdraw_view_mean({&count, 1}, views).numerator, 1.5);
}

TEST(OverdrawFigures, a_view_of_weight_two_counts_as_two_views) {
  const std::vector<ViewTally> counts = tallies({{30, 10, 0}, {10, 10, 0}});
  const std::vector<ViewTally> repeated = tallies({{30, 10, 0}, {10, 10, 0}, {10, 10, 0}});
  std::vector<View> views(2);
  views[1].weight = 2;
  const std::vector<View> alike(3);
  EXPECT_EQ(overdraw_ratio(counts, views).numerator, overdraw_ratio(repeated, alike).numerator);
  EXPECT_EQ(overdraw_ratio(counts, views).denominator, overdraw_ratio(repeated, alike).denominator);
  EXPECT_EQ(overdraw_view_mean(counts, views).numerator, overdraw_view_mean(repeated, alike).numerator);
  EXPECT_EQ(overdraw_view_mean(counts, views).denominator, overdraw_view_mean(repeated, alike).denominator);
}

TEST(OverdrawFigures, an_error_does_not_depend_on_the_scale_of_the_weights) {
  const std::vector<ViewTally> counts = tallies({{30, 10, 0}, {10, 10, 0}, {15, 12, 0}});
  const std::vector<View> views(3);
  std::vector<View> heavy(3);
  for (View& view : heavy) view.weight = 8;
  EXPECT_EQ(overdraw_ratio(counts, views).error, overdraw_ratio(counts, heavy).error);
  EXPECT_EQ(overdraw_view_mean(counts, views).error, overdraw_view_mean(counts, heavy).error);
}

TEST(OverdrawFigures, several_rounds_of_views_take_the_weights_in_turn) {
  const std::vector<ViewTally> counts = tallies({{3, 1, 0}, {1, 1, 0}, {5, 1, 0}, {1, 1, 0}});
  std::vector<View> views(2);
  views[0].weight = 3;
  EXPECT_EQ(overdraw_ratio(counts, views).numerator, 3 * 3 + 1 + 3 * 5 + 1);
  EXPECT_EQ(overdraw_view_mean(counts, views).denominator, 8);
}

TEST(OverdrawFigures, poses_of_a_view_are_one_sample) {
  // Two views in two poses, the second pose three times as heavy.
  std::vector<ViewTally> poses(2);
  poses[0].add({30, 10, 0});
  poses[0].add({10, 10, 0}, 3);
  poses[1].add({20, 20, 0});
  poses[1].add({5, 0, 0}, 3);
  const std::vector<View> views(2);
  const Estimate ratio = overdraw_ratio(poses, views);
  EXPECT_EQ(ratio.numerator, 60 + 35);
  EXPECT_EQ(ratio.denominator, 40 + 20);
  EXPECT_EQ(ratio.error, overdraw_ratio(tallies({{60, 40, 0}, {35, 20, 0}}), views).error);
  const Estimate mean = overdraw_view_mean(poses, views);
  EXPECT_EQ(mean.numerator, 3 + 3 * 1 + 1);
  EXPECT_EQ(mean.denominator, 5);
  // Deviations from 1.4: 6 - 4 * 1.4 and 1 - 1.4.
  EXPECT_NEAR(mean.error, std::sqrt((0.4 * 0.4 + 0.4 * 0.4) * 2) / 5, 1e-12);
}

TEST(OverdrawFigures, the_same_poses_twice_change_no_error) {
  std::vector<ViewTally> once = tallies({{30, 10, 0}, {10, 10, 0}, {5, 0, 0}, {20, 20, 0}});
  std::vector<ViewTally> twice = once;
  for (std::size_t i = 0; i < twice.size(); ++i) twice[i] += once[i];
  const std::vector<View> views(4);
  EXPECT_EQ(overdraw_ratio(once, views).error, overdraw_ratio(twice, views).error);
  EXPECT_EQ(overdraw_view_mean(once, views).error, overdraw_view_mean(twice, views).error);
}

TEST(OverdrawFigures, a_picture_is_worse_where_its_ratio_is_higher) {
  EXPECT_TRUE(is_worse({6, 3, 0}, {10, 10, 0}));
  EXPECT_FALSE(is_worse({10, 10, 0}, {6, 3, 0}));
  EXPECT_FALSE(is_worse({2, 1, 0}, {6, 3, 0}));
  EXPECT_FALSE(is_worse({5, 0, 0}, {10, 10, 0}));
  EXPECT_TRUE(is_worse({10, 10, 0}, {5, 0, 0}));
  EXPECT_FALSE(is_worse({5, 0, 0}, {}));
}

}  // namespace
}  // namespace foredraw::overdraw_figures_test
