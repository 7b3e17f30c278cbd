#include <foredraw/collapses/collapse_limits.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::collapse_limits_test {
namespace {

/// 540 pixels are half the picture, whose edge lies 30 degrees from the middle.
TEST(CollapseLimits, PixelsAreADistance) {
  EXPECT_NEAR(distance_of_pixels(540, 10), 10 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(distance_of_pixels(1, 0), 0);
  EXPECT_NEAR(distance_of_pixels(2, 50), 4 * distance_of_pixels(1, 25), 1e-12);
}

}  // namespace
}  // namespace foredraw::collapse_limits_test
