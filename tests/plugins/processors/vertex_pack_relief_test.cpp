// What materials say of displaced surfaces decides how bits are shared out.
#include "plugins/processors/vertex_pack/relief.h"

#include "support/displaced.h"
#include "support/staged.h"

#include <foredraw/packing/packed_vertices.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::vertex_pack_relief_test {
namespace {

/// 8 by 4 texels that rise by 1000 a texel along u and by 3000 along v; heights from 2000 to 18000.
Image ramp() {
  return testing::height_image(
      8, 4, [](std::uint32_t x, std::uint32_t y) { return static_cast<std::uint16_t>(2000 + 1000 * x + 3000 * y); });
}

TEST(VertexPackRelief, IsThatOfTheMap) {
  Analyses analyses;
  const Scene scene = testing::displaced_grid(4, 4, ramp(), 2, -0.1f);
  const auto relief = processors::vertex_pack::relief_of(scene, 0, analyses);
  ASSERT_TRUE(relief);
  EXPECT_NEAR(relief->displacement, 2 * 18000 / 65535.0 - 0.1, 1e-7);
  EXPECT_NEAR(relief->slope.value(), 2 * std::hypot(8 * 1000, 4 * 3000) / 65535, 1e-7);
  const auto inwards = processors::vertex_pack::relief_of(testing::displaced_grid(4, 4, ramp(), 2, -5), 0, analyses);
  EXPECT_NEAR(inwards->displacement, 5 - 2 * 2000 / 65535.0, 1e-6);
}

TEST(VertexPackRelief, OfAMapThatCanNotBeReadIsWhatTheMaterialSays) {
  Analyses analyses;
  Scene scene = testing::displaced_grid(4, 4, ramp(), 2, -0.5f);
  scene.materials[0].displacement->texture.image = 7;
  const auto relief = processors::vertex_pack::relief_of(scene, 0, analyses);
  ASSERT_TRUE(relief);
  EXPECT_DOUBLE_EQ(relief->displacement, 1.5);
  EXPECT_FALSE(relief->slope);
  scene.materials[0].displacement->factor = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(processors::vertex_pack::relief_of(scene, 0, analyses));
  scene.materials[0].displacement.reset();
  EXPECT_FALSE(processors::vertex_pack::relief_of(scene, 0, analyses));
}

std::uint32_t normal_bits(float factor, const std::string& options) {
  const testing::TestMesh ball = testing::sphere(24, 12);
  std::vector<glm::vec2> uv;
  for (const glm::vec3& at : ball.positions) uv.emplace_back(0.5f + 0.5f * at.x, 0.5f + 0.5f * at.y);
  Scene scene = testing::displaced_scene(ball, uv, ramp(), factor);
  VertexStreams streams = *scene.draws[0].full().vertices;
  streams.base.push_back(testing::float_stream("NORMAL", ball.positions));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(std::move(streams));
  const Scene packed = testing::run("vertex-pack" + options, scene).scene;
  return packed.products.find<PackedVertices>()->draws.at(0).layout.field[FOREDRAW_PACKED_NORMAL_0].bits;
}

/// The deeper the relief, the more bits has the direction along which it goes; an option stands above it.
TEST(VertexPackRelief, SharesOutTheBits) {
  EXPECT_LT(normal_bits(0.001f, ""), normal_bits(30, "(slope=0.2)"));
  EXPECT_EQ(normal_bits(0.001f, "(displacement=0.002, slope=0.2)"), normal_bits(30, "(displacement=0.002, slope=0.2)"));
}

}  // namespace
}  // namespace foredraw::vertex_pack_relief_test
