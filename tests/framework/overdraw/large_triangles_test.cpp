#include <foredraw/overdraw/private/large_triangles.h>

#include "support/vector_widths.h"

#include <gtest/gtest.h>

#include <map>

namespace foredraw::large_triangles_test {
namespace {

/// A sliver along the first row: A = (0, 127), B = (width, 127), C = (width, 130). The doubled area is 3 * width, and
/// at the row's centres (p, 128) the corners weigh 3 * (width - p), 3 * p - width and width.
struct Sliver {
  std::int64_t width;
  std::array<std::int64_t, 3> depths;

  std::int64_t area() const { return 3 * width; }
  std::int64_t numerator(std::int64_t column) const {
    const std::int64_t p = 256 * column + 128;
    return 3 * (width - p) * depths[0] + (3 * p - width) * depths[1] + width * depths[2];
  }
};

/// Such a one whose numerator at the column leaves the remainder area - 1. The width is a prime, 1 more than a multiple
/// of 3.
Sliver just_below(std::int64_t width, std::int64_t column) {
  // With depths a, a + d and a + d + 2 the remainder is that of 2 * width + 3 * p * d. 2 * width + 1 is a multiple
  // of 3.
  const std::int64_t p = (256 * column + 128) % width;
  std::int64_t inverse = 1;  // p^(width - 2): Fermat
  for (std::int64_t power = p, exponent = width - 2; exponent > 0; exponent /= 2, power = power * power % width) {
    if (exponent % 2 == 1) inverse = inverse * power % width;
  }
  const std::int64_t d = (width - (2 * width + 1) / 3) * inverse % width;
  return {width, {5000, 5000 + d, 5000 + d + 2}};
}

/// Such a one whose numerator leaves no remainder at every eleventh column, and far more elsewhere.
Sliver just_reached(std::int64_t width) {
  const std::int64_t d = width / 11;
  return {11 * d, {5000, 5000 + d, 5000 + d}};
}

/// [column]
std::map<std::int64_t, std::int64_t> drawn(const Sliver& sliver) {
  PreparedPart part;
  Corners corners;
  const std::array<std::array<std::int64_t, 2>, 3> places = {{{0, 127}, {sliver.width, 127}, {sliver.width, 130}}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    part.corners[i] = {i};
    corners.points.push_back(static_cast<std::uint64_t>(places[i][1] << 32 | places[i][0]));
    corners.depths.push_back(static_cast<std::uint32_t>(sliver.depths[i]));
  }
  part.numbers = {0};
  Fragments fragments;
  std::map<std::int64_t, std::int64_t> depths;
  const auto take = [&](const Fragments& some) {
    for (std::size_t i = 0; i < some.count; ++i) depths[some.pixels[i]] = some.depths[i];
  };
  draw_large(part, corners, Camera({{0, 0, 1}}, 4096), 0, fragments, take);
  fragments.hand_over(take);
  return depths;
}

void expect_exact(const Sliver& sliver) {
  testing::at_every_width([&] {
    const auto depths = drawn(sliver);
    ASSERT_GT(depths.size(), static_cast<std::size_t>(sliver.width / 512));
    for (const auto& [column, depth] : depths) {
      ASSERT_EQ(depth, sliver.numerator(column) / sliver.area()) << column << " of " << depths.size();
    }
  });
}

// An error of 1 in a numerator shows nowhere but there.

TEST(LargeTriangles, depths_just_below_a_step_are_rounded_down) {
  for (const std::int64_t width : {33013, 262111, 1048573}) {
    const std::int64_t columns = width / 256;
    for (std::int64_t column = columns / 3 + 1; column < columns; column += 1 + columns / 97) {
      const Sliver sliver = just_below(width, column);
      ASSERT_EQ(sliver.numerator(column) % sliver.area(), sliver.area() - 1);
      expect_exact(sliver);
    }
  }
}

TEST(LargeTriangles, depths_that_just_reach_a_step_stay_there) {
  for (std::int64_t width = 33013; width < 1048576; width += 50021) {
    const Sliver sliver = just_reached(width);
    ASSERT_EQ(sliver.numerator(11 * 7 + 5) % sliver.area(), 0);
    ASSERT_NE(sliver.numerator(11 * 7 + 6) % sliver.area(), 0);
    expect_exact(sliver);
  }
}

}  // namespace
}  // namespace foredraw::large_triangles_test
