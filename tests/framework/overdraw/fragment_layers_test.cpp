#include <foredraw/overdraw/fragment_layers.h>

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace foredraw::fragment_layers_test {
namespace {

using testing::painted;
using testing::part_of;
using testing::random_order;
using testing::rising_order;
using testing::TestMesh;

Views few_views(double distance = 0, int size = 48) {
  ViewSet set;
  set.views = "fibonacci";
  set.count = 7;
  set.size = size;
  if (distance > 0) set.distance = distance;
  return make_views(set);
}

FragmentLayers layers_of(const TestMesh& mesh, const Views& views, bool culls_back_faces = true, int threads = 2) {
  const RasterPart part = part_of(mesh, culls_back_faces);
  return fragment_layers({&part, 1}, views, Executor(threads)).value();
}

/// `count` spheres one inside of the other, from the inside out.
TestMesh nested_shells(std::uint32_t count) {
  TestMesh mesh;
  for (std::uint32_t i = 1; i <= count; ++i) {
    mesh = testing::joined(mesh, testing::sphere(24, 16, static_cast<float>(i) / static_cast<float>(count)));
  }
  return mesh;
}

RC_GTEST_PROP(FragmentLayers, count_what_drawing_in_any_order_counts, ()) {
  const std::uint64_t seed = *rc::gen::inRange(0, 1 << 20);
  const bool culls = *rc::gen::element(false, true);
  const TestMesh mesh = testing::tangle(seed, *rc::gen::element(false, true));
  const Views views = few_views(*rc::gen::element(0.0, 1.5), *rc::gen::element(16, 61));
  const FragmentLayers layers = layers_of(mesh, views, culls);
  const ShadedBounds bounds = shaded_bounds(layers);
  const RasterPart part = part_of(mesh, culls);
  for (std::uint64_t i = 0; i < 3; ++i) {
    const auto order = random_order(layers.owners, seed + i);
    RC_ASSERT(count_overdraw_by_view(layers, order) == painted({&part, 1}, views, order));
    const OverdrawCount sum = count_overdraw(layers, order);
    RC_ASSERT(sum.shaded >= bounds.least && sum.shaded <= bounds.most);
    RC_ASSERT(bounds.least == sum.visible);
  }
}

TEST(FragmentLayers, the_tangle_has_what_it_is_for) {
  const Views views = few_views();
  for (const bool twice : {false, true}) {
    const FragmentLayers layers = layers_of(testing::tangle(1, twice), views, false);
    const OverdrawCount count = count_overdraw(layers, random_order(layers.owners, 1));
    EXPECT_GT(4 * count.shaded, 5 * count.visible);
    EXPECT_GT(count.ties, twice ? count.visible : 0u);
  }
}

TEST(FragmentLayers, nested_shells_cost_all_from_the_inside_out_and_one_from_the_outside_in) {
  // Few pixels, so that all shells cover nearly the same ones at the centre: a picture's corner shows what each adds.
  for (const std::uint32_t shells : {2u, 3u, 5u, 9u}) {
    const TestMesh mesh = nested_shells(shells);
    const FragmentLayers layers = layers_of(mesh, few_views());
    std::vector<std::uint32_t> order = rising_order(layers.owners);
    const OverdrawCount inside_out = count_overdraw(layers, order);
    EXPECT_EQ(inside_out.shaded, shaded_bounds(layers).most);
    // Each shell alone covers its share of the picture.
    std::uint64_t covered = 0;
    for (std::uint32_t i = 1; i <= shells; ++i) {
      TestMesh shell = testing::sphere(24, 16, static_cast<float>(i) / static_cast<float>(shells));
      const TestMesh rim = testing::sphere(24, 16);  // the same frame: its triangles repeat a corner and cover nothing
      const auto first = static_cast<std::uint32_t>(shell.positions.size());
      shell.positions.insert(shell.positions.end(), rim.positions.begin(), rim.positions.end());
      for (std::uint32_t p = first; p < shell.positions.size(); ++p)
        shell.indices.insert(shell.indices.end(), {p, p, p});
      const FragmentLayers alone = layers_of(shell, few_views());
      covered += count_overdraw(alone, rising_order(alone.owners)).visible;
    }
    EXPECT_EQ(inside_out.shaded, covered);
    std::ranges::reverse(order);
    EXPECT_EQ(count_overdraw(layers, order).shaded, inside_out.visible);
  }
}

TEST(FragmentLayers, what_a_mask_discards_is_in_no_layer) {
  const TestMesh far = testing::quad(-0.1f), near = testing::quad(0.1f);
  std::vector<RasterPart> parts = {part_of(far), part_of(near)};
  parts[1].mask = testing::half_a_hole();
  const Views front{{View{{0, 0, 1}}}, 64};
  const FragmentLayers layers = *fragment_layers(parts, front, Executor(1));
  const OverdrawCount far_first = count_overdraw(layers, std::vector<std::uint32_t>{0, 1, 2, 3});
  EXPECT_EQ(2 * far_first.shaded, 3 * far_first.visible);
  const OverdrawCount near_first = count_overdraw(layers, std::vector<std::uint32_t>{2, 3, 0, 1});
  EXPECT_EQ(near_first, (OverdrawCount{far_first.visible, far_first.visible, 0, 0}));
  EXPECT_GT(near_first.visible, 1000u);
}

TEST(FragmentLayers, a_stack_of_n_quads_costs_n_or_one) {
  for (const std::uint32_t count : {2u, 3u, 4u, 5u, 40u}) {
    TestMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
      const float z = static_cast<float>(i) / static_cast<float>(count);
      mesh = testing::joined(mesh, {{{-1, -1, z}, {1, -1, z}, {-1, 1, z}, {1, 1, z}}, {0, 1, 2, 2, 1, 3}});
    }
    Views front{{View{}}, 64};
    const FragmentLayers layers = layers_of(mesh, front);
    std::vector<std::uint32_t> order = rising_order(layers.owners);
    const OverdrawCount back_to_front = count_overdraw(layers, order);
    EXPECT_GT(back_to_front.visible, 500u);
    EXPECT_EQ(back_to_front.shaded, count * back_to_front.visible);
    std::ranges::reverse(order);
    EXPECT_EQ(count_overdraw(layers, order).shaded, back_to_front.visible);
    // Two lists in all, one for each half of the quads, however many pixels they cover.
    EXPECT_LT(layers.bytes(), 200 + 2 * count * sizeof(std::uint16_t));
  }
}

TEST(FragmentLayers, parts_are_numbered_through_and_may_be_mixed) {
  const TestMesh a = testing::tangle(3, false);
  const TestMesh b = testing::sphere(12, 8, 0.6f);
  const std::vector<RasterPart> parts = {part_of(a), part_of(b, false), part_of(a)};
  const Views views = few_views(2);
  const FragmentLayers layers = *fragment_layers(parts, views, Executor(2));
  ASSERT_EQ(layers.owners, (2 * a.indices.size() + b.indices.size()) / 3);
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto order = random_order(layers.owners, seed);
    EXPECT_EQ(count_overdraw_by_view(layers, order), painted(parts, views, order));
  }
}

TEST(FragmentLayers, many_triangles_are_told_apart) {
  // More than 15 bits hold beside the one that tells ties, and more than 16.
  for (const std::uint32_t slices : {90u, 180u}) {
    const TestMesh mesh = testing::joined(testing::sphere(slices, 100), testing::sphere(slices, 100));
    ASSERT_GT(mesh.indices.size() / 3, slices == 90 ? 33000u : 66000u);
    const Views views = few_views(0, 128);
    const FragmentLayers layers = layers_of(mesh, views, false);
    const RasterPart part = part_of(mesh, false);
    const auto order = random_order(layers.owners, 1);
    EXPECT_EQ(count_overdraw_by_view(layers, order), painted({&part, 1}, views, order));
  }
}

bool are_equal(const Layers& a, const Layers& b) {
  if (a.owners != b.owners || a.views.size() != b.views.size()) return false;
  for (std::size_t view = 0; view < a.views.size(); ++view) {
    if (a.views[view].always != b.views[view].always || a.views[view].owners != b.views[view].owners) return false;
  }
  return true;
}

TEST(FragmentLayers, one_thread_captures_what_many_do) {
  const TestMesh mesh = testing::tangle(5, false);
  const FragmentLayers one = layers_of(mesh, few_views(), true, 1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(are_equal(layers_of(mesh, few_views(), true, threads), one));
}

TEST(FragmentLayers, what_exceeds_the_limit_is_refused_at_any_number_of_threads) {
  // Fine triangles, so that hardly any lists are equal and a view's fragments are less than what is kept of all views.
  const TestMesh mesh = testing::joined(testing::sphere(90, 60), testing::sphere(90, 60, 0.9f));
  const RasterPart part = part_of(mesh, false);
  const Views views = make_views({.views = "icosphere", .count = 42, .size = 64});
  const std::size_t bytes = fragment_layers({&part, 1}, views, Executor(1))->bytes();
  for (const int threads : {1, 2, 8}) {
    const Executor executor(threads);
    EXPECT_FALSE(fragment_layers({&part, 1}, views, executor, bytes - 1)) << threads;
    EXPECT_FALSE(fragment_layers({&part, 1}, views, executor, 0)) << threads;
    EXPECT_TRUE(fragment_layers({&part, 1}, views, executor, bytes)) << threads;
    EXPECT_TRUE(fragment_layers({&part, 1}, views, executor, std::numeric_limits<std::size_t>::max())) << threads;
  }
}

TEST(FragmentLayers, a_view_with_more_fragments_than_the_limit_is_refused) {
  const TestMesh mesh = testing::sphere(16, 8);  // one layer, of which nothing but a number would be kept
  const RasterPart part = part_of(mesh);
  const Executor executor(2);
  EXPECT_LT(fragment_layers({&part, 1}, few_views(0, 128), executor)->bytes(), 4096u);
  EXPECT_FALSE(fragment_layers({&part, 1}, few_views(0, 128), executor, 4096));
}

TEST(FragmentLayers, nothing_to_see_is_nothing_to_keep) {
  const FragmentLayers none = layers_of(TestMesh(), few_views());
  EXPECT_EQ(count_overdraw(none, {}), OverdrawCount());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const FragmentLayers degenerate = layers_of({{{0, 0, 0}, {1, 0, 0}, {nan, 0, 0}}, {0, 1, 1, 0, 1, 2}}, few_views());
  EXPECT_EQ(degenerate.owners, 2u);
  EXPECT_EQ(count_overdraw(degenerate, rising_order(2)), OverdrawCount());
  EXPECT_EQ(fragment_layers({}, Views(), Executor(1))->views.size(), 0u);
}

TEST(FragmentLayers, what_is_no_order_is_refused) {
  const FragmentLayers layers = layers_of(testing::sphere(6, 4), few_views());
  std::vector<std::uint32_t> order = rising_order(layers.owners);
  order.pop_back();
  EXPECT_THROW(count_overdraw(layers, order), std::invalid_argument);
  order.push_back(0);
  EXPECT_THROW(count_overdraw(layers, order), std::invalid_argument);
  order.back() = static_cast<std::uint32_t>(layers.owners);
  EXPECT_THROW(count_overdraw(layers, order), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::fragment_layers_test
