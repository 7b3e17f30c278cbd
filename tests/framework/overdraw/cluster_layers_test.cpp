#include <foredraw/overdraw/cluster_layers.h>

#include "support/painter.h"

#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace foredraw::cluster_layers_test {
namespace {

using testing::part_of;
using testing::random_order;
using testing::rising_order;
using testing::TestMesh;

Views few_views(int size = 48) { return make_views({.views = "fibonacci", .count = 7, .size = size}); }

/// About `count` clusters, cut where chance says.
Clusters random_clusters(std::size_t triangles, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Clusters clusters{{0}};
  for (std::uint32_t t = 1; t < triangles; ++t) {
    if (random.below(triangles) < count) clusters.offsets.push_back(t);
  }
  clusters.offsets.push_back(static_cast<std::uint32_t>(triangles));
  return clusters;
}

std::vector<std::uint32_t> triangles_in_order(const Clusters& clusters, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t c : order) {
    for (std::uint32_t t = clusters.offsets[c]; t < clusters.offsets[c + 1]; ++t) triangles.push_back(t);
  }
  return triangles;
}

RC_GTEST_PROP(ClusterLayers, count_what_full_layers_count, ()) {
  const std::uint64_t seed = *rc::gen::inRange(0, 1 << 20);
  const TestMesh mesh = testing::tangle(seed, *rc::gen::element(false, true));
  const RasterPart part = part_of(mesh, *rc::gen::element(false, true));
  const Executor executor(2);
  const FragmentLayers full = fragment_layers({&part, 1}, few_views(), executor).value();
  const Clusters clusters = random_clusters(full.owners, *rc::gen::element(1, 2, 5, 20, 1000), seed);
  const ClusterLayers layers = cluster_layers(full, clusters, executor);
  RC_ASSERT(layers.owners == clusters.count());
  const ShadedBounds bounds = shaded_bounds(layers);
  for (std::uint64_t i = 0; i < 3; ++i) {
    const auto order = random_order(clusters.count(), seed + i);
    const std::vector<OverdrawCount> counts = count_overdraw_by_view(layers, order);
    RC_ASSERT(counts == count_overdraw_by_view(full, triangles_in_order(clusters, order)));
    const OverdrawCount sum = count_overdraw(layers, order);
    RC_ASSERT(sum.shaded >= bounds.least && sum.shaded <= bounds.most);
  }
}

TEST(ClusterLayers, clusters_of_one_triangle_are_the_full_layers) {
  const TestMesh mesh = testing::tangle(2, true);
  const RasterPart part = part_of(mesh, false);
  const Executor executor(1);
  const FragmentLayers full = fragment_layers({&part, 1}, few_views(), executor).value();
  const ClusterLayers layers = cluster_layers(full, {rising_order(full.owners + 1)}, executor);
  ASSERT_EQ(layers.views.size(), full.views.size());
  for (std::size_t view = 0; view < full.views.size(); ++view) {
    EXPECT_EQ(layers.views[view].owners, full.views[view].owners);
    EXPECT_EQ(layers.views[view].always, full.views[view].always);
  }
}

TEST(ClusterLayers, one_cluster_leaves_no_list) {
  const TestMesh mesh = testing::tangle(3, true);
  const RasterPart part = part_of(mesh, false);
  const Executor executor(2);
  const FragmentLayers full = fragment_layers({&part, 1}, few_views(), executor).value();
  const Clusters whole{{0, static_cast<std::uint32_t>(full.owners)}};
  const ClusterLayers layers = cluster_layers(full, whole, executor);
  for (const ViewLayers& view : layers.views) EXPECT_TRUE(view.batches.empty());
  EXPECT_EQ(count_overdraw(layers, rising_order(1)), count_overdraw(full, rising_order(full.owners)));
}

TEST(ClusterLayers, what_a_cluster_hides_of_itself_is_left_out) {
  // Two shells a cluster, the outer one drawn first: of each pair one layer is left.
  TestMesh mesh;
  for (const float radius : {0.9f, 0.8f, 1.0f, 0.7f}) mesh = testing::joined(mesh, testing::sphere(16, 8, radius));
  const RasterPart part = part_of(mesh);
  const Executor executor(2);
  const FragmentLayers full = fragment_layers({&part, 1}, few_views(), executor).value();
  const auto half = static_cast<std::uint32_t>(full.owners / 2);
  const ClusterLayers layers = cluster_layers(full, {{0, half, 2 * half}}, executor);
  const ShadedBounds bounds = shaded_bounds(layers);
  const std::vector<std::uint32_t> outer_first = {1, 0};
  EXPECT_EQ(count_overdraw(layers, outer_first).shaded, bounds.least);
  EXPECT_EQ(bounds.least, count_overdraw(layers, outer_first).visible);
  EXPECT_EQ(count_overdraw(layers, rising_order(2)).shaded, bounds.most);
  for (const ViewLayers& view : layers.views) EXPECT_LE(view.batches.size(), 1u);  // outer over inner, once
}

TEST(ClusterLayers, what_is_no_partition_is_refused) {
  const TestMesh mesh = testing::sphere(6, 4);
  const RasterPart part = part_of(mesh);
  const Executor executor(1);
  const FragmentLayers full = fragment_layers({&part, 1}, few_views(), executor).value();
  EXPECT_THROW(cluster_layers(full, {}, executor), std::invalid_argument);
  EXPECT_THROW(cluster_layers(full, {{0, 1}}, executor), std::invalid_argument);
  const auto all = static_cast<std::uint32_t>(full.owners);
  EXPECT_THROW(cluster_layers(full, {{0, 3, 3, all}}, executor), std::invalid_argument);
  const ClusterLayers layers = cluster_layers(full, {{0, 3, all}}, executor);
  EXPECT_THROW(count_overdraw(layers, rising_order(full.owners)), std::invalid_argument);  // an order of triangles
}

}  // namespace
}  // namespace foredraw::cluster_layers_test
