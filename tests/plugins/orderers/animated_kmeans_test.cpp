#include "plugins/orderers/animated_kmeans/animated_kmeans.h"

#include "support/overdraw.h"

#include <foredraw/overdraw/cluster_layers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foredraw::animated_kmeans_test {
namespace {

using testing::TestMesh;
using Numbers = std::vector<std::uint32_t>;

const Views from_before = testing::views_of({{0, 0, 1}});

/// One mesh in several poses.
struct Animated {
  Views views;
  std::vector<TestMesh> poses;
  SubjectLayers subject;
  PatchDistances distances{views.views};

  Animated(std::vector<TestMesh> meshes, const Views& from, const Clusters& patches, bool culls = true)
      : views(from), poses(std::move(meshes)) {
    const Executor executor(2);
    for (std::uint32_t patch = 0; patch < patches.count(); ++patch) subject.owners.push_back({0, 0, patch});
    subject.draws.push_back({poses[0].indices, poses[0].positions.size(), patches});
    for (const TestMesh& pose : poses) {
      const RasterPart part{pose.positions, pose.indices, culls};
      ClusterLayers layers = cluster_layers(fragment_layers({&part, 1}, views, executor).value(), patches, executor);
      subject.layers.owners = layers.owners;
      for (std::size_t v = 0; v < views.views.size(); ++v) {
        subject.layers.views.push_back(std::move(layers.views[v]));
        subject.directions.push_back(views.views[v].direction);
        subject.weights.push_back(views.views[v].weight);
      }
      distances.add_pose(subject, {&part, 1}, executor);
    }
  }
  Animated(const Animated&) = delete;

  IndexBuffers ordered(int k, std::uint64_t seed = 0, int threads = 2, int restarts = 0) const {
    return animated_kmeans(subject, distances, {.k = k, .restarts = restarts, .seed = seed}, Executor(threads));
  }
  double excess(std::span<const OverdrawCount> counts) const {
    const ViewTally tally = tally_of(subject, counts);
    return tally.shaded / tally.visible - 1;
  }
};

/// Squares that face +Z at these heights, two triangles each; one with its height negative faces -Z at the opposite.
TestMesh squares(const std::vector<float>& heights) {
  TestMesh all;
  for (const float z : heights) {
    TestMesh square = testing::quad(std::abs(z));
    if (z < 0) std::swap(square.indices[1], square.indices[2]), std::swap(square.indices[4], square.indices[5]);
    all = all.indices.empty() ? square : testing::joined(all, square);
  }
  return all;
}

/// Two rings that turn through one another.
std::vector<TestMesh> turning_rings() {
  std::vector<TestMesh> poses;
  for (int pose = 0; pose < 5; ++pose) {
    const TestMesh still = testing::torus(24, 10);
    TestMesh turned = still;
    const float sine = 0.2f * static_cast<float>(pose), cosine = std::sqrt(1 - sine * sine);
    for (glm::vec3& p : turned.positions) p = {cosine * p.y - sine * p.z + 0.5f, p.x, sine * p.y + cosine * p.z};
    poses.push_back(testing::joined(still, turned));
  }
  return poses;
}

Clusters runs_of(std::uint32_t size, std::uint32_t triangles) {
  Clusters clusters{{0}};
  while (clusters.offsets.back() < triangles) {
    clusters.offsets.push_back(std::min(triangles, clusters.offsets.back() + size));
  }
  return clusters;
}

// --- distances
// -----------------------------------------------------------------------------------------------------------

TEST(PatchDistances, DistancesAreInRadiiFromTheCentre) {
  // The sphere around both squares: in the middle between them, of radius sqrt(1 + 1 + 1/4).
  const Views views{{{{0, 0, 1}, 0}, {{0, 0, 1}, 3}, {{1, 0, 0}, 3}}, 64};
  const Animated still({squares({1, 2})}, views, {{0, 2, 4}});
  EXPECT_NEAR(still.distances.distance(0, 0), 1.0 / 3, 1e-12);
  EXPECT_NEAR(still.distances.distance(0, 1), -1.0 / 3, 1e-12);
  EXPECT_NEAR(still.distances.distance(1, 1), 3 - 1.0 / 3, 1e-12);
  EXPECT_NEAR(still.distances.distance(2, 1), std::sqrt(9 + 1.0 / 9), 1e-12);
}

TEST(PatchDistances, PatchesFaceTheCameraThatSeesTheirFront) {
  const Views views{{{{0, 0, 1}}, {{0, 0, -1}}, {{0.8, 0, 0.6}, 3}}, 64};
  const Animated culled({squares({1, -2})}, views, {{0, 2, 4}});
  EXPECT_TRUE(culled.distances.is_facing(0, 0));
  EXPECT_FALSE(culled.distances.is_facing(0, 1));
  EXPECT_FALSE(culled.distances.is_facing(1, 0));
  EXPECT_TRUE(culled.distances.is_facing(1, 1));
  EXPECT_TRUE(culled.distances.is_facing(2, 0));
  EXPECT_FALSE(culled.distances.is_facing(2, 1));
  const Animated both({squares({1, -2})}, views, {{0, 2, 4}}, false);
  for (std::size_t look = 0; look < 3; ++look) EXPECT_TRUE(both.distances.is_facing(look, 1));
  // As one patch they face all sides.
  const Animated one({squares({1, -2})}, views, {{0, 4}});
  for (std::size_t look = 0; look < 3; ++look) EXPECT_TRUE(one.distances.is_facing(look, 0));
}

TEST(PatchDistances, WhatHasNoAreaOrIsNotFiniteFacesNobody) {
  TestMesh mesh = squares({1, 2, 3});
  for (std::size_t v = 0; v < 4; ++v) mesh.positions[v] = {0, 0, 1};
  mesh.positions[8].x = std::nanf("");
  mesh.positions[10].y = INFINITY;
  const Animated odd({mesh}, from_before, {{0, 2, 4, 6}});
  EXPECT_FALSE(odd.distances.is_facing(0, 0));
  EXPECT_TRUE(odd.distances.is_facing(0, 1));
  EXPECT_FALSE(odd.distances.is_facing(0, 2));
  std::vector<IntegratedDistance> sums(3);
  odd.distances.integrate(0, 2, sums);
  EXPECT_EQ(sums[0].looks, 0);
  EXPECT_EQ(sums[1].looks, 2);
  EXPECT_TRUE(std::isfinite(sums[1].distance));
}

// --- orders
// -----------------------------------------------------------------------------------------------------------

TEST(AnimatedKMeans, TwoOrdersServePosesThatHideTheOtherWayRound) {
  const Animated swapped({squares({1, 2}), squares({2, 1})}, from_before, {{0, 2, 4}});
  EXPECT_EQ(swapped.excess(swapped.ordered(1).counts), 0.5);
  for (const int k : {2, 255}) {  // more orders than nodes too
    const IndexBuffers two = swapped.ordered(k);
    EXPECT_EQ(swapped.excess(two.counts), 0) << k;
    ASSERT_EQ(two.orders.size(), 2u);
    EXPECT_EQ(two.orders[two.serving[0]][0], (Numbers{1, 0}));
    EXPECT_EQ(two.orders[two.serving[1]][0], (Numbers{0, 1}));
  }
}

TEST(AnimatedKMeans, NodesThatAreAllAlikeShareOneOrder) {
  const Animated alike(std::vector<TestMesh>(4, squares({1, 3, 2})), from_before, {{0, 2, 4, 6}});
  const IndexBuffers found = alike.ordered(3);
  ASSERT_EQ(found.orders.size(), 1u);
  EXPECT_EQ(found.orders[0][0], (Numbers{1, 2, 0}));
  EXPECT_EQ(found.serving, std::vector<std::uint8_t>(4, 0));
}

TEST(AnimatedKMeans, DistancesAreIntegratedAndWhatNoNodeSeesGoesLast) {
  // The first square is nearest and turns its back. Of the others the second hides the third in two poses of three: by
  // whichever the order begins, it draws the second first in the end.
  const Animated three({squares({-9, 5, 2}), squares({-9, 5, 2}), squares({-9, 3, 4})}, from_before, {{0, 2, 4, 6}});
  bool was_computed = false;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Numbers order = three.ordered(1, seed).orders[0][0];
    was_computed |= order == Numbers{1, 2, 0};
    EXPECT_TRUE(order == (Numbers{1, 2, 0}) || order == (Numbers{0, 1, 2})) << "sorted, or as its look has it";
  }
  EXPECT_TRUE(was_computed);
}

TEST(AnimatedKMeans, WhatNobodySeesHasOneOrderAllTheSame) {
  const Animated unseen({squares({-1, -2}), squares({-2, -1})}, from_before, {{0, 2, 4}});
  const IndexBuffers found = unseen.ordered(5);
  ASSERT_EQ(found.orders.size(), 1u);
  Numbers order = found.orders[0][0];
  std::ranges::sort(order);
  EXPECT_EQ(order, (Numbers{0, 1}));
}

TEST(AnimatedKMeans, WithoutNodesPatchesStayAsTheyCame) {
  const Animated nowhere({squares({1, 2})}, Views{{}, 64}, {{0, 2, 4}});
  const IndexBuffers found = nowhere.ordered(5);
  ASSERT_EQ(found.orders.size(), 1u);
  EXPECT_EQ(found.orders[0][0], (Numbers{0, 1}));
}

TEST(AnimatedKMeans, NodesAreServedByTheOrderThatDrawsLeastThere) {
  const std::vector<TestMesh> poses = turning_rings();
  const Animated rings(poses, testing::all_sides(64, 0, 42),
                       runs_of(8, static_cast<std::uint32_t>(poses[0].indices.size() / 3)));
  const IndexBuffers found = rings.ordered(5);
  ASSERT_GT(found.orders.size(), 1u);
  for (const auto& order : found.orders) {
    const std::vector<OverdrawCount> alone = counts_of(rings.subject, order);
    for (std::size_t look = 0; look < alone.size(); ++look) EXPECT_LE(found.counts[look].shaded, alone[look].shaded);
    EXPECT_LE(rings.excess(counts_of(rings.subject, found.orders[0])), rings.excess(alone))
        << "the first is best alone";
  }
}

TEST(AnimatedKMeans, MoreOrdersAndMoreStartsLeaveLess) {
  const std::vector<TestMesh> poses = turning_rings();
  const Animated rings(poses, testing::all_sides(64, 0, 42),
                       runs_of(8, static_cast<std::uint32_t>(poses[0].indices.size() / 3)));
  const double one = rings.excess(rings.ordered(1).counts), five = rings.excess(rings.ordered(5).counts);
  EXPECT_LT(five, 0.7 * one);
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const double once = rings.excess(rings.ordered(3, seed).counts);
    EXPECT_LE(rings.excess(rings.ordered(3, seed, 2, 4).counts), once);
  }
}

TEST(AnimatedKMeans, TheBestOfItsStartsIsTheBestByItsMetric) {
  const std::vector<TestMesh> poses = turning_rings();
  const Animated rings(poses, testing::all_sides(64, 3, 42),
                       runs_of(8, static_cast<std::uint32_t>(poses[0].indices.size() / 3)));
  const auto tally_by = [&](OverdrawMetric metric) {  // one round: both choose among the same starts
    const AnimatedKMeansOptions options{.k = 2, .restarts = 15, .rounds = 1, .metric = metric};
    return tally_of(rings.subject, animated_kmeans(rings.subject, rings.distances, options, Executor(2)).counts);
  };
  const ViewTally by_ratio = tally_by(OverdrawMetric::ratio), by_mean = tally_by(OverdrawMetric::view_mean);
  EXPECT_LE(by_ratio.shaded, by_mean.shaded);
  EXPECT_LE(by_mean.ratios, by_ratio.ratios);
}

TEST(AnimatedKMeans, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<TestMesh> poses = turning_rings();
  const Animated rings(poses, testing::all_sides(64, 0, 42),
                       runs_of(5, static_cast<std::uint32_t>(poses[0].indices.size() / 3)));
  const IndexBuffers a = rings.ordered(4, 7, 1), b = rings.ordered(4, 7, 2);
  EXPECT_EQ(a.orders, b.orders);
  EXPECT_EQ(a.serving, b.serving);
  EXPECT_EQ(a.counts, b.counts);
}

}  // namespace
}  // namespace foredraw::animated_kmeans_test
