#include <foredraw/displaced/cage_buffers.h>

#include "support/displaced.h"

#include <gtest/gtest.h>
#include <glm/vec4.hpp>

#include <stdexcept>

namespace foredraw::cage_buffers_test {
namespace {

TEST(CageBuffers, AVertexHasWhatTheShadersReadOfIt) {
  const std::vector<glm::vec3> positions = {{1, 2, 3}, {4, 5, 6}}, directions = {{0, 0, 1}, {0, 1, 0}};
  const auto vertices =
      cage_vertices(positions, directions, std::vector<std::array<std::int32_t, 2>>{{7, 8}, {-9, 10}});
  ASSERT_EQ(vertices.size(), 2u);
  const auto* words = reinterpret_cast<const float*>(vertices.data());
  EXPECT_EQ(std::vector<float>(words + 8, words + 11), (std::vector<float>{4, 5, 6}));
  EXPECT_EQ(std::vector<float>(words + 12, words + 15), (std::vector<float>{0, 1, 0}));
  EXPECT_EQ(vertices[1].x, -9);
  EXPECT_EQ(vertices[1].y, 10);
  static_assert(sizeof(foredraw_cage_vertex) == 32 && sizeof(foredraw_cage_skin) == 32 &&
                sizeof(foredraw_cage_map) == 48);
  EXPECT_THROW(cage_vertices(positions, directions, {}), std::invalid_argument);
}

TEST(CageBuffers, AVertexHasItsFourLargestInfluences) {
  using Row = glm::vec4;
  VertexStreams vertices;
  vertices.count = 3;
  vertices.base = {
      testing::float_stream("JOINTS_0", std::vector<Row>{{5, 1, 2, 3}, {0, 1, 9, 0}, {9, 9, 9, 9}}),
      testing::float_stream(
          "WEIGHTS_0", std::vector<Row>{{.125f, .25f, .125f, .0625f}, {.25f, .25f, .5f, 0}, {.25f, .25f, .25f, .25f}}),
      testing::float_stream("JOINTS_1", std::vector<Row>{{4, 6, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}),
      testing::float_stream("WEIGHTS_1", std::vector<Row>{{.375f, .0625f, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}})};
  const auto skin = cage_skin(vertices, 7);
  const auto joints = [&](std::size_t v) { return std::vector<std::uint32_t>(skin[v].joint, skin[v].joint + 4); };
  const auto weights = [&](std::size_t v) { return std::vector<float>(skin[v].weight, skin[v].weight + 4); };
  EXPECT_EQ(joints(0), (std::vector<std::uint32_t>{4, 1, 2, 5}));
  EXPECT_EQ(weights(0), (std::vector<float>{.375f / .875f, .25f / .875f, .125f / .875f, .125f / .875f}));
  EXPECT_EQ(joints(1), (std::vector<std::uint32_t>{0, 1, 0, 0}));  // there is no joint 9
  EXPECT_EQ(weights(1), (std::vector<float>{.5f, .5f, 0, 0}));
  EXPECT_EQ(joints(2), (std::vector<std::uint32_t>{7, 0, 0, 0}));
  EXPECT_EQ(weights(2), (std::vector<float>{1, 0, 0, 0}));
}

}  // namespace
}  // namespace foredraw::cage_buffers_test
