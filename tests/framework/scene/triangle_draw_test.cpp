#include <foredraw/scene/triangle_draw.h>

#include <gtest/gtest.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <stdexcept>

namespace foredraw::triangle_draw_test {
namespace {

TEST(TriangleDraw, HoldsWhatItIsGiven) {
  const std::array<glm::vec3, 3> positions = {glm::vec3{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const std::vector<glm::vec4> colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  const Draw draw = triangle_draw("one", positions, {2, 0, 1}, {float_stream("COLOR_0", colours)});
  EXPECT_EQ(draw.name, "one");
  ASSERT_EQ(draw.levels.size(), 1u);
  const VertexStreams& vertices = *draw.levels[0].vertices;
  EXPECT_EQ(vertices.count, 3u);
  EXPECT_EQ(decode_vec3(*vertices.find("POSITION")), std::vector<glm::vec3>(positions.begin(), positions.end()));
  EXPECT_EQ(vertices.find("COLOR_0")->format, (Format{Component::float32, 4, false, 16}));
  EXPECT_EQ(decode_component(*vertices.find("COLOR_0"), 2, 3), 0.5f);
  ASSERT_EQ(draw.levels[0].orders.size(), 1u);
  EXPECT_EQ(draw.levels[0].orders[0].indices, Shared<std::uint32_t>({2, 0, 1}));
}

TEST(TriangleDraw, RefusesWhatDoesNotFitTogether) {
  const std::vector<glm::vec3> positions(3);
  EXPECT_THROW(triangle_draw("odd", positions, {0, 1}), std::invalid_argument);
  EXPECT_THROW(triangle_draw("odd", positions, {0, 1, 3}), std::invalid_argument);
  const VertexStream few = float_stream("TEXCOORD_0", std::vector<glm::vec2>(2));
  EXPECT_THROW(triangle_draw("odd", positions, {0, 1, 2}, {few}), std::invalid_argument);
  EXPECT_NO_THROW(triangle_draw("empty", {}, {}));
}

}  // namespace
}  // namespace foredraw::triangle_draw_test
