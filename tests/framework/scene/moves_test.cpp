#include <foredraw/scene/moves.h>

#include "support/meshes.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>

namespace foredraw::moves_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

Draw moved(const Draw& draw, const Numbers& destination, std::uint32_t count) {
  const auto streams =
      std::make_shared<const VertexStreams>(with_vertices_moved(*draw.full().vertices, destination, count));
  return with_vertices_moved(draw, 0, streams, destination);
}

Draw four_vertices() { return testing::draw_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {0, 1, 2, 2, 1, 3}}); }

TEST(Moves, AreThoseOfTheMoveAloneHoweverOftenVerticesMovedBefore) {
  const Draw first = four_vertices();
  const Draw welded = moved(first, {0, 1, 1, 2}, 3);
  const Draw renumbered = moved(welded, {2, 0, 1}, 3);
  EXPECT_EQ(vertex_moves(first.full(), first.full()), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(vertex_moves(first.full(), welded.full()), (Numbers{0, 1, 1, 2}));
  EXPECT_EQ(vertex_moves(welded.full(), renumbered.full()), (Numbers{2, 0, 1}));
  EXPECT_EQ(vertex_moves(first.full(), renumbered.full()), (Numbers{2, 0, 0, 1}));
}

TEST(Moves, OfVerticesThatAreGoneSaySo) {
  const Draw first = four_vertices();
  EXPECT_EQ(vertex_moves(first.full(), moved(first, {no_vertex, 0, 1, 2}, 3).full()), (Numbers{no_vertex, 0, 1, 2}));
}

TEST(Moves, AreNotKnownWhereADrawWasMadeAnew) {
  EXPECT_EQ(vertex_moves(four_vertices().full(), testing::draw_of(testing::grid(1, 2)).full()), std::nullopt);
  EXPECT_EQ(triangle_moves(four_vertices().full().stream(), testing::draw_of(testing::grid(2, 2)).full().stream()),
            std::nullopt);
}

TEST(Moves, OfTrianglesComposeTheirOrders) {
  const IndexStream first = testing::draw_of(testing::soup(3, 1)).full().stream();
  const IndexStream second = with_triangle_order(first, Numbers{2, 0, 1});  // [new] = old
  const IndexStream third = with_triangle_order(second, Numbers{1, 2, 0});
  EXPECT_EQ(triangle_moves(first, second), (Numbers{1, 2, 0}));
  EXPECT_EQ(triangle_moves(second, third), (Numbers{2, 0, 1}));
  EXPECT_EQ(triangle_moves(first, third), (Numbers{0, 1, 2}));
}

TEST(Moves, OfBoundsStayUnderOrdersWithinRangesAndMoveWhereTrianglesAreDropped) {
  const IndexStream first = testing::draw_of(testing::soup(5, 1)).full().stream();
  const Numbers bounds{2, 3};
  EXPECT_EQ(moved_bounds(bounds, first, first), bounds);
  const IndexStream within = with_triangle_order(first, Numbers{1, 0, 2, 4, 3});
  EXPECT_EQ(moved_bounds(bounds, first, within), bounds);
  EXPECT_EQ(moved_bounds(bounds, within, first), bounds);
  EXPECT_EQ(moved_bounds(bounds, first, with_triangle_order(first, Numbers{2, 1, 0, 3, 4})), std::nullopt);
  const auto kept = [](const IndexStream& of, const Numbers& triangles) {
    IndexStream fewer = of;
    Numbers indices, origin;
    for (const std::uint32_t t : triangles) {
      for (std::size_t c = 0; c < 3; ++c) indices.push_back(of.indices.view()[3 * std::size_t{t} + c]);
      origin.push_back(of.triangle_origin.empty() ? t : of.triangle_origin.view()[t]);
    }
    fewer.indices = Shared<std::uint32_t>(std::move(indices));
    fewer.triangle_origin = Shared<std::uint32_t>(std::move(origin));
    return fewer;
  };
  EXPECT_EQ(moved_bounds(bounds, first, kept(first, {1, 3, 4})), (Numbers{1, 1}));
  EXPECT_EQ(moved_bounds(bounds, within, kept(within, {0, 2})), (Numbers{1, 2}));
  EXPECT_EQ(moved_bounds(bounds, kept(first, {0, 3}), first), std::nullopt) << "triangles that were not there";
}

TEST(Moves, OfAFirstRangeCountWhatIsStillInFront) {
  const IndexStream first = testing::draw_of(testing::soup(5, 1)).full().stream();
  EXPECT_EQ(kept_first(3, first, first), 3u);
  const IndexStream within = with_triangle_order(first, Numbers{1, 2, 0, 4, 3});
  EXPECT_EQ(kept_first(3, first, within), 3u);
  EXPECT_EQ(kept_first(3, within, first), 3u);
  const IndexStream taken = with_triangle_order(within, Numbers{0, 2, 3, 4, 1});  // one went to the end
  EXPECT_EQ(kept_first(3, within, taken), 2u);
  EXPECT_EQ(kept_first(5, first, taken), 5u);
  EXPECT_EQ(kept_first(2, first, with_triangle_order(first, Numbers{4, 0, 1, 2, 3})), 0u) << "another came before";
  IndexStream made_anew = testing::draw_of(testing::soup(4, 1)).full().stream();
  EXPECT_EQ(kept_first(3, first, made_anew), 0u);
}

}  // namespace
}  // namespace foredraw::moves_test
