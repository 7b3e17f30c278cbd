#include <foredraw/page/file_numbering.h>

#include "support/meshes.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>

namespace foredraw::file_numbering_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

Level level_of(std::vector<glm::vec3> positions, Numbers indices) {
  return testing::draw_of({std::move(positions), std::move(indices)}).full();
}

/// The level's triangles by place, in the sequence of their numbers.
std::vector<glm::vec3> corners_in_file(const Level& level) {
  const Places places = places_of(level);
  const Numbers numbers = numbers_in_file(level.stream(), places);
  const auto positions = decode_vec3(*level.vertices->find("POSITION"));
  std::vector<glm::vec3> corners(3 * numbers.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t place = places.of_vertex[level.stream().indices.view()[i]];
    corners[3 * std::size_t{numbers[i / 3]} + i % 3] = positions[places.vertex[place]];
  }
  return corners;
}

TEST(Places, OfVerticesAtTheSamePointAreOne) {
  const Places places = places_of(level_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {0, 1, 3, 2, 3, 1}));
  EXPECT_EQ(places.of_vertex, (Numbers{0, 1, 0, 2}));
  EXPECT_EQ(places.vertex, (Numbers{0, 1, 3}));
}

/// Joints move apart what is at one point at rest.
TEST(Places, OfVerticesThatMoveApartAreTwo) {
  Level level = level_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {0, 1, 2});
  VertexStreams vertices = *level.vertices;
  const auto bytes = [](int a, int b, int c) {
    return Shared<std::byte>({static_cast<std::byte>(a), static_cast<std::byte>(b), static_cast<std::byte>(c)});
  };
  vertices.base.push_back({"COLOR_0", {Component::uint8, 1, true, 1}, bytes(1, 2, 3)});
  level.vertices = std::make_shared<VertexStreams>(vertices);
  EXPECT_EQ(places_of(level).vertex.size(), 2u);
  vertices.base.push_back({"JOINTS_0", {Component::uint8, 1, false, 1}, bytes(4, 5, 4)});
  level.vertices = std::make_shared<VertexStreams>(vertices);
  EXPECT_EQ(places_of(level).vertex.size(), 3u);
}

TEST(Places, AreThoseOfTheFileWhereverAVertexWent) {
  Draw draw = testing::draw_of(testing::grid(3, 2));
  const Places before = places_of(draw.full());
  Numbers destination(12);
  for (std::uint32_t v = 0; v < 12; ++v) destination[v] = (5 * v + 3) % 12;
  const auto moved = std::make_shared<VertexStreams>(with_vertices_moved(*draw.full().vertices, destination, 12));
  draw = with_vertices_moved(draw, 0, moved, destination);
  draw.full().vertex_destination = Shared<std::uint32_t>(destination);
  const Places after = places_of(draw.full());
  for (std::uint32_t v = 0; v < 12; ++v) EXPECT_EQ(after.of_vertex[destination[v]], before.of_vertex[v]);
}

TEST(NumbersInFile, UndoAnyOrder) {
  const Draw draw = testing::draw_of(testing::grid(4, 3));
  Numbers order(24);
  for (std::uint32_t t = 0; t < 24; ++t) order[t] = (7 * t + 5) % 24;
  const Draw sorted = with_triangle_order(draw, order);
  EXPECT_EQ(numbers_in_file(sorted.full().stream(), places_of(sorted.full())), order);
  EXPECT_EQ(corners_in_file(sorted.full()), corners_in_file(draw.full()));
}

/// As where both sides of one are drawn: whichever comes first, they are the same two.
TEST(NumbersInFile, OfTwoFromOneTriangleDoNotDependOnTheirOrder) {
  Level level = level_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {1, 3, 2, 0, 1, 2, 0, 2, 1});
  level.stream().triangle_origin = Shared<std::uint32_t>(Numbers{7, 4, 4});
  Level turned = level_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 2, 1, 1, 3, 2, 0, 1, 2});
  turned.stream().triangle_origin = Shared<std::uint32_t>(Numbers{4, 7, 4});
  EXPECT_EQ(numbers_in_file(level.stream(), places_of(level)), (Numbers{2, 0, 1}));
  EXPECT_EQ(corners_in_file(level), corners_in_file(turned));
}

}  // namespace
}  // namespace foredraw::file_numbering_test
