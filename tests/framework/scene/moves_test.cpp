#include <foredraw/scene/moves.h>

#include "support/meshes.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>

namespace foredraw {
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

}  // namespace
}  // namespace foredraw
