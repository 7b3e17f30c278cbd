#include <foredraw/overdraw/draw_sequence.h>

#include "support/painter.h"

#include <foredraw/base/random.h>
#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace foredraw::overdraw_draw_sequence_test {
namespace {

std::vector<std::uint32_t> as_numbered(std::uint32_t parts) {
  std::vector<std::uint32_t> sequence(parts);
  std::iota(sequence.begin(), sequence.end(), 0u);
  return sequence;
}

using testing::TestMesh;

PartGroup all_free(std::uint32_t parts) { return {as_numbered(parts + 1)}; }

/// Lists of some of the parts each, in random sequences, with random weights.
PartLists random_lists(std::uint32_t parts, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  PartLists lists;
  lists.parts = parts;
  for (std::size_t l = 0; l < count; ++l) {
    std::vector<std::uint32_t> list = as_numbered(parts);
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
    list.resize(2 + random.below(parts - 1));
    lists.layers.insert(lists.layers.end(), list.begin(), list.end());
    lists.first.push_back(static_cast<std::uint32_t>(lists.layers.size()));
    lists.weights.push_back(static_cast<std::int64_t>(1 + random.below(100)));
  }
  return lists;
}

PartLists lists_of(std::uint32_t parts,
                   const std::vector<std::pair<std::vector<std::uint32_t>, std::int64_t>>& weighted) {
  PartLists lists;
  lists.parts = parts;
  for (const auto& [list, weight] : weighted) {
    lists.layers.insert(lists.layers.end(), list.begin(), list.end());
    lists.first.push_back(static_cast<std::uint32_t>(lists.layers.size()));
    lists.weights.push_back(weight);
  }
  return lists;
}

/// The least that any sequence shades which the groups allow.
std::int64_t least_of_all(const PartLists& lists, std::span<const PartGroup> groups) {
  std::vector<std::uint32_t> sequence = as_numbered(lists.parts);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  do {
    if (is_allowed(sequence, groups)) least = std::min(least, fragments_shaded(lists, sequence));
  } while (std::ranges::next_permutation(sequence).found);
  return least;
}

TEST(DrawSequence, FindsTheBestOfAllSequences) {
  const Executor executor(2);
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const PartLists lists = random_lists(8, 5 + 10 * seed, seed);
    const std::vector<PartGroup> groups = {all_free(8)};
    const auto found = draw_sequence(lists, groups, {.seed = seed}, executor);
    EXPECT_EQ(fragments_shaded(lists, found), least_of_all(lists, groups)) << seed;
  }
}

TEST(DrawSequence, FindsTheBestThatGroupsAllow) {
  // Parts 1 to 3 stay together, and 2 and 3 change places only among themselves; nothing passes part 4.
  const std::vector<PartGroup> groups = {{{2, 3, 4}}, {{0, 1, 4}}, {{5, 6, 7, 8}}};
  const Executor executor(2);
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const PartLists lists = random_lists(8, 60, seed);
    const auto found = draw_sequence(lists, groups, {.seed = seed}, executor);
    EXPECT_TRUE(is_allowed(found, groups)) << seed;
    EXPECT_EQ(fragments_shaded(lists, found), least_of_all(lists, groups)) << seed;
  }
}

TEST(DrawSequence, IsTheSameAtAnyNumberOfThreads) {
  const PartLists lists = random_lists(30, 2000, 1);
  const std::vector<PartGroup> groups = {all_free(30)};
  EXPECT_EQ(draw_sequence(lists, groups, {}, Executor(1)), draw_sequence(lists, groups, {}, Executor(3)));
}

TEST(DrawSequence, DrawsFirstWhatHides) {
  const PartLists lists = lists_of(3, {{{2, 0}, 5}, {{2, 1}, 5}, {{1, 0}, 1}});
  const std::vector<PartGroup> groups = {all_free(3)};
  EXPECT_EQ(draw_sequence(lists, groups, {}, Executor(1)), (std::vector<std::uint32_t>{2, 1, 0}));
  EXPECT_EQ(fragments_shaded(lists, as_numbered(3)), 22);
  EXPECT_EQ(fragments_shaded(lists, std::vector<std::uint32_t>{2, 1, 0}), 11);
}

TEST(DrawSequence, MovesNothingForNothing) {
  const Executor executor(1);
  const std::vector<PartGroup> groups = {all_free(4)};
  EXPECT_EQ(draw_sequence(lists_of(4, {}), groups, {}, executor), as_numbered(4));
  EXPECT_EQ(draw_sequence(lists_of(4, {{{0, 3}, 2}, {{3, 0}, 2}}), groups, {}, executor), as_numbered(4));
  EXPECT_EQ(draw_sequence(lists_of(4, {{{3, 2}, 1}}), groups, {}, executor), (std::vector<std::uint32_t>{0, 1, 3, 2}));
  EXPECT_EQ(draw_sequence(lists_of(4, {{{3, 2}, 1}}), {}, {}, executor), as_numbered(4)) << "nothing is free";
}

TEST(DrawSequence, WhatHidesNothingStaysBehind) {
  const Executor executor(2);
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    PartLists lists = random_lists(8, 60, seed);
    lists.parts = 11;  // the last three are in no list
    const std::vector<PartGroup> groups = {all_free(11)};
    const auto found = draw_sequence(lists, groups, {.seed = seed}, executor);
    EXPECT_EQ(std::vector(found.end() - 3, found.end()), (std::vector<std::uint32_t>{8, 9, 10})) << seed;
  }
}

TEST(PartLists, CountWhatDrawingCounts) {
  // Spheres in one another, each a part, and each convex: it hides nothing of itself.
  TestMesh all;
  Clusters shells{{0}};
  for (const float radius : {0.5f, 1.0f, 0.75f}) {
    const TestMesh one = testing::sphere(16, 8, radius);
    all = all.indices.empty() ? one : testing::joined(all, one);
    shells.offsets.push_back(static_cast<std::uint32_t>(all.indices.size() / 3));
  }
  const RasterPart part = testing::part_of(all, true);
  const Executor executor(2);
  const Views views = make_views({.views = "fibonacci", .count = 7, .size = 48});
  const ClusterLayers layers = cluster_layers(fragment_layers({&part, 1}, views, executor).value(), shells, executor);
  const std::vector<std::int64_t> weights(views.views.size(), 3);
  const PartLists lists = part_lists(layers, as_numbered(3), 3, weights);
  const std::int64_t pixels = std::accumulate(lists.weights.begin(), lists.weights.end(), std::int64_t{0});
  std::vector<std::uint32_t> sequence = as_numbered(3);
  do {
    const OverdrawCount count = count_overdraw(layers, sequence);
    EXPECT_EQ(fragments_shaded(lists, sequence) - pixels, 3 * static_cast<std::int64_t>(count.shaded - count.visible));
  } while (std::ranges::next_permutation(sequence).found);
  for (std::size_t l = 1; l < lists.count(); ++l) {
    EXPECT_TRUE(std::ranges::lexicographical_compare(lists.list(l - 1), lists.list(l))) << "equal lists are one";
  }
  EXPECT_EQ(part_lists(layers, as_numbered(3), 3, std::vector<std::int64_t>(views.views.size(), 0)).count(), 0u);
}

TEST(PartLists, HaveAPartOnce) {
  Layers layers;
  layers.owners = 4;
  layers.views.resize(1);
  layers.views[0].batches = {{.length = 4, .weight = 2, .lists = 1}};
  layers.views[0].owners = std::vector<std::uint16_t>{3, 0, 2, 1};
  const std::vector<std::uint32_t> part_of = {0, 1, 0, 1};  // owners 3 and 1 are one part's, 0 and 2 the other's
  const PartLists lists = part_lists(layers, part_of, 2, std::vector<std::int64_t>{5});
  ASSERT_EQ(lists.count(), 1u);
  EXPECT_TRUE(std::ranges::equal(lists.list(0), std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(lists.weights[0], 10);
}

}  // namespace
}  // namespace foredraw::overdraw_draw_sequence_test
