#include <foredraw/displaced/height_range.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

namespace foredraw::height_range_test {
namespace {

using Corners = std::array<std::array<std::int32_t, 2>, 3>;

std::vector<std::uint16_t> texels(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint16_t> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(static_cast<std::uint16_t>(random.below(65536)));
  return result;
}

std::int32_t between(Random& random, int least, int most) {
  return static_cast<std::int32_t>(least +
                                   static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1))));
}

/// Texels that points of the triangle have a part of, by looking at very many of them.
HeightRange found(const foredraw_height_map& map, const Corners& corners, Random& random, int points) {
  HeightRange range;
  for (int i = 0; i < points; ++i) {
    const auto u = static_cast<std::uint32_t>(random.below(65537));
    const auto v = static_cast<std::uint32_t>(random.below(65537 - u));
    const std::uint32_t weights[3] = {u, v, 65536 - u - v};
    const std::int32_t x[3] = {corners[0][0], corners[1][0], corners[2][0]};
    const std::int32_t y[3] = {corners[0][1], corners[1][1], corners[2][1]};
    const auto at =
        foredraw_height_footprint_at(&map, foredraw_height_between(x, weights), foredraw_height_between(y, weights));
    for (std::size_t k = 0; k < 4; ++k) {
      if (at.weight[k] == 0) continue;
      const std::uint16_t texel = map.texels[at.row[k / 2] * map.width + at.column[k % 2]];
      range.add({texel, texel});
    }
  }
  return range;
}

/// Small triangles anywhere, also far beyond the edges: no point is outside, and nothing is counted that is not there.
TEST(HeightRanges, AreThoseOfTheTexelsUnderATriangle) {
  Random random(1);
  int exact = 0, all = 0;
  for (const auto& [width, height] : {std::pair{16u, 16u}, {37u, 9u}, {1u, 1u}, {1u, 50u}, {64u, 3u}}) {
    const std::vector<std::uint16_t> content = texels(std::size_t{width} * height, width);
    for (const std::uint8_t wrap : {FOREDRAW_HEIGHT_REPEAT, FOREDRAW_HEIGHT_MIRRORED, FOREDRAW_HEIGHT_CLAMPED}) {
      for (const std::uint8_t nearest : {0, 1}) {
        const foredraw_height_map map{content.data(), width, height, {wrap, wrap}, nearest};
        const HeightRanges ranges(map);
        for (int i = 0; i < 60; ++i) {
          Corners corners;
          const std::int32_t x = between(random, -40'000, 40'000), y = between(random, -40'000, 40'000);
          for (auto& corner : corners) corner = {x + between(random, 0, 2000), y + between(random, 0, 2000)};
          const HeightRange range = ranges.over(corners), seen = found(map, corners, random, 3000);
          EXPECT_LE(range.least, seen.least);
          EXPECT_GE(range.most, seen.most);
          exact += range == seen, ++all;
        }
      }
    }
  }
  EXPECT_GT(exact, all * 8 / 10) << "of " << all << ": texels at a corner are seldom hit by chance";
}

TEST(HeightRanges, OfATriangleLeaveOutWhatLiesBesideIt) {
  // All is 100 but a column of 9.
  std::vector<std::uint16_t> content(64 * 64, 100);
  for (std::size_t row = 0; row < 64; ++row) content[row * 64 + 20] = 9;
  const foredraw_height_map map{content.data(), 64, 64, {0, 0}, 0};
  const HeightRanges ranges(map);
  const auto place = [](double texel) { return static_cast<std::int32_t>(256 * texel); };
  const auto least = [&](double from, double to) {
    return ranges.over({{{place(from), 0}, {place(to), place(40)}, {place(from), place(63)}}}).least;
  };
  EXPECT_EQ(least(30, 60), 100);
  EXPECT_EQ(least(10, 60), 9);
  EXPECT_EQ(least(21.6, 60), 100);
  EXPECT_EQ(least(21.4, 60), 9) << "its middle is at 20.5, and it reaches as far as the next one's";
  // Beside a slanted edge, within the box.
  EXPECT_EQ(ranges.over({{{place(0), place(63)}, {place(40), place(63)}, {place(40), place(50)}}}).least, 9);
  EXPECT_EQ(ranges.over({{{place(18), place(0)}, {place(18), place(63)}, {place(0), place(30)}}}).least, 100);
}

TEST(HeightRanges, OfLargeTrianglesAreNeverTooSmall) {
  Random random(2);
  const std::vector<std::uint16_t> content = texels(300 * 200, 5);
  for (const std::uint8_t wrap : {FOREDRAW_HEIGHT_REPEAT, FOREDRAW_HEIGHT_MIRRORED, FOREDRAW_HEIGHT_CLAMPED}) {
    const foredraw_height_map map{content.data(), 300, 200, {wrap, wrap}, 0};
    const HeightRanges ranges(map);
    for (int i = 0; i < 40; ++i) {
      Corners corners;
      for (auto& corner : corners) corner = {between(random, -200'000, 200'000), between(random, -200'000, 200'000)};
      const HeightRange range = ranges.over(corners), seen = found(map, corners, random, 3000);
      EXPECT_LE(range.least, seen.least);
      EXPECT_GE(range.most, seen.most);
    }
    constexpr std::int32_t far = FOREDRAW_HEIGHT_MOST_PLACE;
    const HeightRange all = ranges.over({{{-far, -far}, {far, -far}, {0, far}}});
    EXPECT_LE(all.least, content[0]);
    EXPECT_GE(all.most, content[0]);
  }
}

}  // namespace
}  // namespace foredraw::height_range_test
