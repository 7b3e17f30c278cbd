#include <foredraw/image/alpha_image.h>

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::alpha_image_test {
namespace {

/// Of 4 x 2 texels: 0, 1/3, 2/3, 1 above, all 1 below.
double alpha_of(Wrap wrap, bool is_nearest, const glm::dvec2& place) {
  const AlphaImage image{4, 2, {0, 65535 / 3, 65535 / 3 * 2, 65535, 65535, 65535, 65535, 65535}};
  return alpha_at(image, {{wrap, wrap}, is_nearest}, place);
}

TEST(AlphaAt, the_nearest_texel_is_the_one_that_the_place_lies_in) {
  const auto at = [](const glm::dvec2& place) { return alpha_of(Wrap::repeat, true, place); };
  EXPECT_EQ(at({0.01, 0.2}), 0);
  EXPECT_EQ(at({0.26, 0.2}), 1.0 / 3);
  EXPECT_EQ(at({0.99, 0.49}), 1);
  EXPECT_EQ(at({0.01, 0.51}), 1);
}

TEST(AlphaAt, texels_are_blended_between_their_centres) {
  const auto at = [](const glm::dvec2& place) { return alpha_of(Wrap::clamped, false, place); };
  EXPECT_EQ(at({0.125, 0.25}), 0);
  EXPECT_EQ(at({0.375, 0.25}), 1.0 / 3);
  EXPECT_DOUBLE_EQ(at({0.25, 0.25}), 1.0 / 6);
  EXPECT_DOUBLE_EQ(at({0.125, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(at({0.25, 0.5}), (1.0 / 6 + 1) / 2);
}

TEST(AlphaAt, beyond_the_edges_an_image_repeats_turns_back_or_stays) {
  EXPECT_EQ(alpha_of(Wrap::repeat, true, {1.3, -0.9}), 1.0 / 3);
  EXPECT_EQ(alpha_of(Wrap::mirrored, true, {1.3, 0.1}), 2.0 / 3);
  EXPECT_EQ(alpha_of(Wrap::mirrored, true, {-0.3, -0.1}), 1.0 / 3);
  EXPECT_EQ(alpha_of(Wrap::clamped, true, {1.3, 0.1}), 1);
  EXPECT_EQ(alpha_of(Wrap::clamped, true, {-7, -7}), 0);
  // Halfway between the last texel and what comes behind it.
  EXPECT_DOUBLE_EQ(alpha_of(Wrap::repeat, false, {1, 0.25}), 0.5);
  EXPECT_DOUBLE_EQ(alpha_of(Wrap::mirrored, false, {1, 0.25}), 1);
}

TEST(AlphaAt, places_that_are_nowhere_are_at_the_corner) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double place : {nan, infinity, -infinity, 1e30}) {
    EXPECT_EQ(alpha_of(Wrap::repeat, true, {place, place}), 0);
    EXPECT_EQ(alpha_of(Wrap::mirrored, false, {place, place}), 0);
  }
}

Texels texels(std::uint32_t width, std::uint32_t height, int channels, std::vector<int> values) {
  Texels made{{width, height, channels, 8, false}, {}};
  for (const int value : values) made.bytes.push_back(static_cast<std::byte>(value));
  return made;
}

TEST(AlphaImage, is_made_of_the_channel_that_shows) {
  const Texels pixel = texels(1, 1, 4, {255, 0, 0, 128});
  EXPECT_EQ(alpha_image(pixel).alpha, std::vector<std::uint16_t>{257 * 128});
  EXPECT_EQ(alpha_image(pixel, AlphaChannel::any).alpha, std::vector<std::uint16_t>{65535});
  EXPECT_NEAR(alpha_image(pixel, AlphaChannel::luminance).alpha[0], 0.2126 * 65535, 2);
  EXPECT_EQ(alpha_image(texels(1, 1, 3, {9, 9, 9})).alpha, std::vector<std::uint16_t>{65535});
  EXPECT_EQ(alpha_image(texels(1, 1, 2, {9, 7})).alpha, std::vector<std::uint16_t>{257 * 7});
  EXPECT_EQ(alpha_image(texels(1, 1, 1, {9}), AlphaChannel::luminance).alpha, std::vector<std::uint16_t>{257 * 9});
}

TEST(AlphaImage, what_shows_at_all_never_becomes_nothing) {
  EXPECT_EQ(alpha_image(texels(1, 1, 3, {0, 0, 1}), AlphaChannel::luminance).alpha[0] > 0, true);
  const AlphaImage lonely = next_level({2, 2, {1, 0, 0, 0}});
  EXPECT_EQ(lonely.alpha, std::vector<std::uint16_t>{1});
}

TEST(AlphaImage, a_level_of_an_odd_size_weighs_what_its_texels_cover) {
  const AlphaImage level = next_level({5, 1, {50, 0, 100, 0, 30}});
  EXPECT_EQ(level.width, 2u);
  EXPECT_EQ(level.height, 1u);
  EXPECT_EQ(level.alpha, (std::vector<std::uint16_t>{40, 32}));  // (50 + 0 + 100 / 2) / 2.5, (100 / 2 + 0 + 30) / 2.5
  EXPECT_EQ(next_level({1, 1, {7}}).alpha, std::vector<std::uint16_t>{7});
}

}  // namespace
}  // namespace foredraw::alpha_image_test
