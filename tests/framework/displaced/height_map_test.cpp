#include <foredraw/displaced/height_map.h>

#include "support/displaced.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::height_map_test {
namespace {

template <class T>
Texels texels_of(std::uint32_t width, std::uint32_t height, int channels, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {{width, height, channels, static_cast<int>(8 * sizeof(T)), std::is_same_v<T, float>},
          {bytes.begin(), bytes.end()}};
}

using Heights = std::vector<std::uint16_t>;

TEST(HeightMap, IsTheFirstChannelInSixteenBits) {
  EXPECT_EQ(height_map(texels_of<std::uint8_t>(2, 1, 3, {0, 9, 9, 255, 9, 9})).texels, (Heights{0, 65535}));
  EXPECT_EQ(height_map(texels_of<std::uint8_t>(1, 1, 1, {1})).texels, (Heights{257}));
  EXPECT_EQ(height_map(texels_of<std::uint16_t>(1, 2, 2, {7, 1, 65535, 1})).texels, (Heights{7, 65535}));
}

TEST(HeightMap, OfFloatsIsClampedAndOfNoNumbersZero) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const HeightMap map = height_map(
      texels_of<float>(7, 1, 1, {-1, 0.5f, 1, 2, infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}));
  EXPECT_EQ(map.texels, (Heights{0, 32768, 65535, 65535, 65535, 0, 0}));
}

TEST(HeightMap, IsDecodedOnceAndKeptOrItIsSaidWhyNot) {
  Analyses analyses;
  const Image image =
      testing::height_image(3, 2, [](auto x, auto y) { return static_cast<std::uint16_t>(x + 10 * y); });
  const auto map = height_map_of(analyses, image);
  EXPECT_EQ(std::get<0>(map)->texels, (Heights{0, 1, 2, 10, 11, 12}));
  EXPECT_EQ(std::get<0>(height_map_of(analyses, image)), std::get<0>(map));
  EXPECT_FALSE(std::get<1>(height_map_of(analyses, Image{.name = "none"})).empty());
}

TEST(HeightMap, LiesWhereTheTextureTransformPutsIt) {
  const HeightMap map{4, 2, Heights(8)};
  const VertexStream texcoords = float_stream("TEXCOORD_0", std::vector<glm::vec2>{{0, 0}, {0.5f, 0.5f}, {1, 1}});
  const Texture texture{.scale = {2, 1}, .offset = {0, 0.25}};
  const auto places = height_places(texcoords, texture, map);
  EXPECT_EQ(places[0], (std::array<std::int32_t, 2>{0, 128}));
  EXPECT_EQ(places[1], (std::array<std::int32_t, 2>{1024, 384}));
  EXPECT_EQ(places[2], (std::array<std::int32_t, 2>{2048, 640}));
}

TEST(HeightMap, IsSampledByTheTexturesWraps) {
  const HeightMap map{2, 1, {0, 65535}};
  const Texture texture{.wrap = {Wrap::mirrored, Wrap::clamped}};
  const foredraw_height_map ready = sampled(map, texture);
  EXPECT_EQ(foredraw_displaced_height(&ready, 128, 128, 16), 0u);
  EXPECT_EQ(foredraw_displaced_height(&ready, 384, 128, 16), 65535u);
  EXPECT_EQ(foredraw_displaced_height(&ready, 640, -9999, 16), 65535u) << "mirrored";
  EXPECT_EQ(foredraw_displaced_height(&ready, 256, 128, 16), 32767u) << "half between";
}

}  // namespace
}  // namespace foredraw::height_map_test
