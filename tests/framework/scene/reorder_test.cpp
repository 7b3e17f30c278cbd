#include <foredraw/scene/reorder.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace foredraw::reorder_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers numbers(const Shared<std::uint32_t>& shared) { return {shared.view().begin(), shared.view().end()}; }

IndexStream stream_of(const Numbers& indices) { return {.indices = Shared<std::uint32_t>(indices)}; }

/// Triangle t has the corners 3t, 3t + 1, 3t + 2.
IndexStream separate(std::uint32_t triangles) {
  Numbers indices(3 * std::size_t{triangles});
  for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
  return stream_of(indices);
}

Numbers random_permutation(std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  Numbers order(count);
  for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
  for (std::uint32_t n = count; n > 1; --n) std::swap(order[n - 1], order[random.below(n)]);
  return order;
}

TEST(IsPermutation, EveryNumberOnce) {
  EXPECT_TRUE(is_permutation(Numbers{2, 0, 1}, 3));
  EXPECT_TRUE(is_permutation(Numbers{}, 0));
  EXPECT_FALSE(is_permutation(Numbers{0, 1, 1}, 3)) << "doubled";
  EXPECT_FALSE(is_permutation(Numbers{0, 1, 3}, 3)) << "too great";
  EXPECT_FALSE(is_permutation(Numbers{0, 1}, 3)) << "too few";
  EXPECT_FALSE(is_permutation(Numbers{0, 1, 2, 3}, 3)) << "too many";
}

TEST(TriangleOrder, MovesTrianglesWithoutRotatingThem) {
  const IndexStream moved = with_triangle_order(stream_of({0, 1, 2, 2, 1, 3, 3, 1, 4}), Numbers{2, 0, 1});
  EXPECT_EQ(numbers(moved.indices), (Numbers{3, 1, 4, 0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(numbers(moved.triangle_origin), (Numbers{2, 0, 1}));
}

TEST(TriangleOrder, OriginsComposeOverTwoOrders) {
  const IndexStream once = with_triangle_order(separate(4), Numbers{2, 0, 3, 1});
  const IndexStream twice = with_triangle_order(once, Numbers{3, 0, 1, 2});
  EXPECT_EQ(numbers(twice.triangle_origin), (Numbers{1, 2, 0, 3}));
}

RC_GTEST_PROP(TriangleOrder, origin_says_where_each_triangle_was, (std::uint64_t seed)) {
  const auto count = *rc::gen::inRange(0u, 30u);
  IndexStream stream = separate(count);
  for (std::uint64_t step = 0; step < 3; ++step) {
    stream = with_triangle_order(stream, random_permutation(count, seed + step));
    for (std::uint32_t t = 0; t < count; ++t) {
      for (std::uint32_t corner = 0; corner < 3; ++corner) {
        RC_ASSERT(stream.indices.view()[3 * t + corner] == 3 * stream.triangle_origin.view()[t] + corner);
      }
    }
  }
}

TEST(TriangleOrder, KeepsWhatDoesNotMove) {
  IndexStream stream = separate(2);
  stream.cache_size = 24;
  const Shared<std::uint32_t> before = stream.indices;
  EXPECT_EQ(with_triangle_order(stream, Numbers{1, 0}).cache_size, 24);
  EXPECT_TRUE(stream.indices.is(before)) << "the stream that was given stays";
}

TEST(TriangleOrder, ClustersMovedWholeGetNewOffsets) {
  IndexStream stream = separate(6);
  stream.clusters = Clusters{{0, 1, 3, 6}};
  // The last cluster first and turned round inside, then the first, then the second.
  const IndexStream moved = with_triangle_order(stream, Numbers{5, 3, 4, 0, 2, 1});
  ASSERT_TRUE(moved.clusters);
  EXPECT_EQ(moved.clusters->offsets, (Numbers{0, 3, 4, 6}));
}

TEST(TriangleOrder, TornClustersAreLost) {
  IndexStream stream = separate(6);
  stream.clusters = Clusters{{0, 1, 3, 6}};
  EXPECT_FALSE(with_triangle_order(stream, Numbers{3, 0, 4, 5, 1, 2}).clusters);
  EXPECT_FALSE(with_triangle_order(separate(6), Numbers{0, 1, 2, 3, 4, 5}).clusters) << "there were none";
}

TEST(TriangleOrder, NoTrianglesKeepTheirNoClusters) {
  IndexStream stream = separate(0);
  stream.clusters = Clusters{{0}};
  const IndexStream moved = with_triangle_order(stream, Numbers{});
  ASSERT_TRUE(moved.clusters);
  EXPECT_TRUE(is_partition(*moved.clusters, 0));
}

RC_GTEST_PROP(TriangleOrder, clusters_are_kept_exactly_where_each_stays_in_one_piece, (std::uint64_t seed)) {
  const Numbers sizes = *rc::gen::container<Numbers>(4, rc::gen::inRange(1u, 3u));
  Clusters clusters{{0}};
  for (const std::uint32_t size : sizes) clusters.offsets.push_back(clusters.offsets.back() + size);
  const std::uint32_t count = clusters.offsets.back();
  IndexStream stream = separate(count);
  stream.clusters = clusters;
  const Numbers order = random_permutation(count, seed);

  bool whole = true;
  for (std::uint32_t c = 0; c < clusters.count(); ++c) {
    std::uint32_t first = count, last = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (order[i] < clusters.offsets[c] || order[i] >= clusters.offsets[c + 1]) continue;
      first = std::min(first, i);
      last = std::max(last, i);
    }
    whole = whole && last - first + 1 == sizes[c];
  }
  const auto moved = with_triangle_order(stream, order).clusters;
  RC_ASSERT(moved.has_value() == whole);
  if (moved) RC_ASSERT(is_partition(*moved, count));
  RC_CLASSIFY(whole, "whole");
}

// Draws.

VertexStream uint32_stream(std::string name, const Numbers& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(name), {Component::uint32, 1, false, 4}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

Numbers values_of(const VertexStream& stream) {
  Numbers values(stream.bytes.size() / 4);
  std::memcpy(values.data(), stream.bytes.view().data(), stream.bytes.size());
  return values;
}

TEST(TriangleOrderOfDraw, TornClustersTakeTheTraitAlong) {
  Draw draw = testing::draw_of(testing::soup(4, 1));
  draw.full().made.add(traits::clustered);
  draw.levels[0].orders[0].clusters = Clusters{{0, 2, 4}};
  EXPECT_TRUE(with_triangle_order(draw, Numbers{2, 3, 1, 0}).full().made.has(traits::clustered));
  const Draw torn = with_triangle_order(draw, Numbers{0, 2, 1, 3});
  EXPECT_FALSE(torn.full().made.has(traits::clustered));
  EXPECT_FALSE(torn.levels[0].orders[0].clusters);
  EXPECT_TRUE(torn.traits.has(traits::triangles));
}

std::vector<float> first_coordinates(const VertexStream& stream) {
  std::vector<float> xs;
  for (const glm::vec3& position : decode_vec3(stream)) xs.push_back(position.x);
  return xs;
}

TEST(VerticesMoved, PermutesEveryStreamAndMorphTarget) {
  VertexStreams streams = *testing::vertex_streams({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  const auto target = testing::vertex_streams({{4, 0, 0}, {5, 0, 0}, {6, 0, 0}});
  streams.morph_targets = {target->base, {uint32_stream("T", {7, 8, 9})}};
  const VertexStreams moved = with_vertices_moved(streams, Numbers{2, 0, 1}, 3);
  EXPECT_EQ(moved.count, 3u);
  EXPECT_EQ(first_coordinates(moved.base[0]), (std::vector<float>{2, 3, 1}));
  EXPECT_EQ(first_coordinates(moved.morph_targets[0][0]), (std::vector<float>{5, 6, 4}));
  EXPECT_EQ(values_of(moved.morph_targets[1][0]), (Numbers{8, 9, 7}));
  EXPECT_EQ(moved.base[0].semantic, "POSITION");
  EXPECT_EQ(moved.base[0].format, streams.base[0].format);
}

TEST(VerticesMoved, MergesAndLeavesOut) {
  const auto streams = testing::vertex_streams({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {4, 0, 0}});
  const VertexStreams moved = with_vertices_moved(*streams, Numbers{1, no_vertex, 1, 0}, 2);
  EXPECT_EQ(moved.count, 2u);
  EXPECT_EQ(first_coordinates(moved.base[0]), (std::vector<float>{4, 1}));
}

TEST(VerticesMovedInDraw, RenumbersEveryOrderOfItsLevelAlone) {
  Draw draw = testing::draw_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2}});
  draw.levels[0].orders.push_back(stream_of({2, 0, 1}));
  draw.levels.push_back(draw.levels[0]);
  const Numbers destination = {1, 2, 0};
  const auto moved =
      std::make_shared<const VertexStreams>(with_vertices_moved(*draw.levels[0].vertices, destination, 3));
  const Draw result = with_vertices_moved(draw, 0, moved, destination);
  EXPECT_EQ(numbers(result.levels[0].orders[0].indices), (Numbers{1, 2, 0}));
  EXPECT_EQ(numbers(result.levels[0].orders[1].indices), (Numbers{0, 1, 2}));
  EXPECT_EQ(result.levels[0].vertices, moved);
  EXPECT_EQ(numbers(result.levels[1].orders[0].indices), (Numbers{0, 1, 2}));
  EXPECT_EQ(result.levels[1].vertices, draw.levels[1].vertices);
  EXPECT_TRUE(result.levels[1].vertex_destination.empty());
}

TEST(VerticesMovedInDraw, DestinationsComposeOverTwoMoves) {
  Draw draw = testing::draw_of({{{1, 0, 0}, {9, 0, 0}, {1, 0, 0}, {4, 0, 0}, {5, 0, 0}}, {0, 3, 4, 2, 4, 3}});
  const auto move = [&](const Numbers& destination, std::uint32_t count) {
    const auto moved =
        std::make_shared<const VertexStreams>(with_vertices_moved(*draw.levels[0].vertices, destination, count));
    draw = with_vertices_moved(draw, 0, moved, destination);
  };
  move({0, no_vertex, 0, 1, 2}, 3);  // 0 and 2 are one, nobody uses 1
  EXPECT_EQ(numbers(draw.levels[0].vertex_destination), (Numbers{0, no_vertex, 0, 1, 2}));
  move({2, 0, 1}, 3);
  EXPECT_EQ(numbers(draw.levels[0].vertex_destination), (Numbers{2, no_vertex, 2, 0, 1}));
  EXPECT_EQ(numbers(draw.levels[0].orders[0].indices), (Numbers{2, 0, 1, 2, 1, 0}));
  EXPECT_EQ(first_coordinates(draw.levels[0].vertices->base[0]), (std::vector<float>{4, 5, 1}));
}

TEST(Reorder, OrderBetweenIsFoundWhateverCornersTurn) {
  const Numbers from = {0, 1, 2, 2, 1, 3, 0, 1, 2, 4, 4, 1};
  EXPECT_EQ(order_between(from, from), (IndexOrder{0, 1, 2, 3}));
  EXPECT_EQ(order_between(from, Numbers{4, 1, 4, 1, 2, 0, 3, 2, 1, 2, 0, 1}), (IndexOrder{3, 0, 1, 2}));
  EXPECT_EQ(order_between(from, Numbers{4, 1, 4, 1, 0, 2, 3, 2, 1, 2, 0, 1}), std::nullopt) << "one is turned over";
  EXPECT_EQ(order_between(from, Numbers{0, 1, 2}), std::nullopt);
  EXPECT_EQ(order_between(Numbers{}, Numbers{}), IndexOrder{});
}

}  // namespace
}  // namespace foredraw::reorder_test
