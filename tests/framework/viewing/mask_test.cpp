#include <foredraw/viewing/mask.h>

#include <gtest/gtest.h>

namespace foredraw::mask_test {
namespace {

TEST(MaskedTriangle, is_there_where_the_alpha_between_its_corners_reaches_the_cutoff) {
  Mask mask;
  mask.alphas = {0, 1, 0};
  mask.cutoff = 0.25;
  const Camera camera({{0, 0, 1}}, 16);
  const MaskedTriangle triangle(mask, camera, {0, 1, 2}, {Corner{0, 0, 9}, Corner{4000, 0, 9}, Corner{0, 4000, 9}});
  EXPECT_FALSE(triangle.is_there(999, 500));
  EXPECT_TRUE(triangle.is_there(1000, 500));
  EXPECT_TRUE(triangle.is_there(1000, 3000));
}

TEST(MaskedTriangle, what_is_evenly_as_high_as_the_cutoff_is_there) {
  Mask mask;
  mask.cutoff = 0.3;
  mask.alphas.assign(3, mask.cutoff);
  const Camera camera({{0, 0, 1}, 1.5}, 16);
  const MaskedTriangle triangle(mask, camera, {0, 1, 2}, {Corner{3, 5, 7}, Corner{997, 11, 13}, Corner{19, 991, 17}});
  for (int x = 10; x < 400; x += 3) EXPECT_TRUE(triangle.is_there(x, 400));
}

TEST(MaskedTriangle, in_perspective_the_middle_of_the_picture_is_nearer_to_the_near_corner) {
  Mask mask;
  mask.alphas = {0, 1, 1};
  mask.cutoff = 0.5;
  const View view{{0, 0, 1}, 2};
  const Camera camera(view, 16);
  const auto far = static_cast<std::uint32_t>(2 * depth_steps - 1);  // three times as far off as depth 0
  const std::array<Corner, 3> corners = {Corner{0, 0, 0}, Corner{4000, 0, far}, Corner{4000, 400, far}};
  const MaskedTriangle triangle(mask, camera, {0, 1, 2}, corners);
  EXPECT_FALSE(triangle.is_there(2990, 10));
  EXPECT_TRUE(triangle.is_there(3010, 10));
  EXPECT_TRUE(MaskedTriangle(mask, Camera({{0, 0, 1}}, 16), {0, 1, 2}, corners).is_there(2010, 10));
}

TEST(MaskedTriangle, does_not_depend_on_which_corner_comes_first) {
  Mask mask;
  mask.image = std::make_shared<const AlphaImage>(
      AlphaImage{4, 2, {0, 65535 / 3, 65535 / 3 * 2, 65535, 65535, 65535, 65535, 65535}});
  mask.uv = {{0.1, 0.2}, {7.3, 0.9}, {2.1, 5.7}};
  mask.alphas = {0.9, 0.8, 0.7};
  mask.cutoff = 0.55;
  const Camera camera({{0, 0, 1}, 1.3}, 16);
  const std::array<Corner, 3> c = {Corner{0, 10, 9000}, Corner{4000, 0, 70000}, Corner{50, 3900, 12345678}};
  const MaskedTriangle one(mask, camera, {0, 1, 2}, c);
  const MaskedTriangle turned(mask, camera, {1, 2, 0}, {c[1], c[2], c[0]});
  const MaskedTriangle flipped(mask, camera, {0, 2, 1}, {c[0], c[2], c[1]});
  int there = 0;
  for (int y = 100; y < 1900; y += 37) {
    for (int x = 100; x < 1900; x += 41) {
      there += one.is_there(x, y) ? 1 : 0;
      EXPECT_EQ(turned.is_there(x, y), one.is_there(x, y));
      EXPECT_EQ(flipped.is_there(x, y), one.is_there(x, y));
    }
  }
  EXPECT_GT(there, 100);
  EXPECT_LT(there, 2000);
}

}  // namespace
}  // namespace foredraw::mask_test
