#include <foredraw/base/random.h>
#include <foredraw/displaced/edge_division.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace foredraw::edge_division_test {
namespace {

using enum TessellationSpacing;

constexpr TessellationSpacing spacings[] = {equal, fractional_odd, fractional_even};

TEST(EdgeDivision, levels_are_clamped_and_rounded_as_vulkan_says) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  for (const TessellationSpacing spacing : spacings) {
    for (const float level : {0.0f, -0.0f, -1.0f, -endless, none}) EXPECT_EQ(effective_level(level, spacing), 0);
  }
  EXPECT_EQ(effective_level(1e-30f, equal), 1);
  EXPECT_EQ(effective_level(1, equal), 1);
  EXPECT_EQ(effective_level(std::nextafter(1.0f, 2.0f), equal), 2);
  EXPECT_EQ(effective_level(12.5f, equal), 13);
  EXPECT_EQ(effective_level(64.5f, equal), 64);
  EXPECT_EQ(effective_level(endless, equal), 64);
  EXPECT_EQ(effective_level(0.25f, fractional_odd), 1);
  EXPECT_EQ(effective_level(2.75f, fractional_odd), 2.75f);
  EXPECT_EQ(effective_level(endless, fractional_odd), 63);
  EXPECT_EQ(effective_level(0.25f, fractional_even), 2);
  EXPECT_EQ(effective_level(63.5f, fractional_even), 63.5f);
  EXPECT_EQ(effective_level(endless, fractional_even), 64);
  const float unit = 1.0f / 65536;  // ties go to the even one
  EXPECT_EQ(effective_level(1 + 0.5f * unit, fractional_odd), 1);
  EXPECT_EQ(effective_level(1 + 0.75f * unit, fractional_odd), 1 + unit);
  EXPECT_EQ(effective_level(1 + 1.5f * unit, fractional_odd), 1 + 2 * unit);
}

TEST(EdgeDivision, has_as_many_parts_as_vulkan_says) {
  for (int i = 1; i <= 640; ++i) {
    const float level = static_cast<float>(i) / 10;
    const auto parts = [&](TessellationSpacing spacing) {
      return EdgeDivision(effective_level(level, spacing), spacing).parts();
    };
    const auto up = static_cast<std::uint32_t>(std::ceil(level));
    EXPECT_EQ(parts(equal), up);
    EXPECT_EQ(parts(fractional_odd), std::min(up | 1, 63u)) << level;
    EXPECT_EQ(parts(fractional_even), std::max(up + up % 2, 2u)) << level;
  }
}

/// Of the parts, in 1 / 65536.
std::vector<int> lengths(const EdgeDivision& edge) {
  std::vector<int> lengths;
  const auto place = [&](std::uint32_t point) { return static_cast<int>(edge.place(point)); };
  for (std::uint32_t i = 0; i < edge.parts(); ++i) lengths.push_back(place(i + 1) - place(i));
  return lengths;
}

TEST(EdgeDivision, begins_and_ends_at_the_corners_and_is_the_same_from_both) {
  Random random(1);
  for (const TessellationSpacing spacing : spacings) {
    for (int i = 0; i < 2000; ++i) {
      const EdgeDivision edge(effective_level(static_cast<float>(random.unit() * 65), spacing), spacing);
      EXPECT_EQ(edge.place(0), 0u);
      EXPECT_EQ(edge.place(edge.parts()), weight_one);
      for (std::uint32_t p = 0; p <= edge.parts(); ++p) {
        EXPECT_EQ(edge.place(p) + edge.place(edge.parts() - p), weight_one);
      }
    }
  }
}

TEST(EdgeDivision, equal_parts_are_equal_but_for_rounding) {
  for (int level = 1; level <= 64; ++level) {
    const EdgeDivision edge(static_cast<float>(level), equal);
    for (int p = 0; p <= level; ++p) {
      const double place = 65536.0 * p / level;
      // A part's length is rounded once, then up to 32 of them lie in a row.
      EXPECT_NEAR(edge.place(static_cast<std::uint32_t>(p)), place, 0.5 * std::min(p, level - p)) << level;
    }
  }
}

TEST(EdgeDivision, fractional_levels_give_parts_of_one_length_but_for_two_shorter_ones) {
  Random random(2);
  for (const TessellationSpacing spacing : {fractional_odd, fractional_even}) {
    for (int i = 0; i < 5000; ++i) {
      const float level = effective_level(static_cast<float>(2 + random.unit() * 60), spacing);
      const EdgeDivision edge(level, spacing);
      std::vector<int> sorted = lengths(edge);
      std::ranges::sort(sorted);
      // The middle one has what rounding left, half a unit for each other one.
      constexpr int rounding = 32;
      EXPECT_LE(sorted[1] - sorted[0], rounding) << level;
      EXPECT_LE(sorted.back() - sorted[2], rounding) << level;
      // The two shorter ones grow from 0, where there are two parts less, to the length of the others.
      const double more = level - (edge.parts() - 2.0), share = more / 2;
      EXPECT_NEAR(sorted[0], 65536 * share / edge.parts(), rounding) << level;
      EXPECT_NEAR(sorted[2], 65536 * ((1 - share) / (edge.parts() - 2) + share / edge.parts()), rounding) << level;
    }
  }
}

TEST(EdgeDivision, parts_are_hardly_ever_turned_over) {
  const auto shortest = [](TessellationSpacing spacing, std::uint32_t least, std::uint32_t most) {
    int shortest = 0;
    for (std::uint32_t fixed = least * weight_one; fixed <= most * weight_one; ++fixed) {  // every level
      const EdgeDivision edge(static_cast<float>(fixed) / weight_one, spacing);
      int before = 0;
      for (std::uint32_t p = 1; 2 * p <= edge.parts() + 1; ++p) {
        const int place = static_cast<int>(edge.place(p));
        shortest = std::min(shortest, place - before);
        before = place;
      }
    }
    return shortest;
  };
  EXPECT_EQ(shortest(fractional_odd, 1, 63), 0);
  EXPECT_EQ(shortest(fractional_even, 2, 64), -7);
}

TEST(EdgeDivision, points_move_a_little_when_the_level_does) {
  for (const TessellationSpacing spacing : {fractional_odd, fractional_even}) {
    EdgeDivision before(effective_level(2, spacing), spacing);
    for (int i = 2 * 256; i < 63 * 256; ++i) {
      const EdgeDivision after(effective_level(static_cast<float>(i) / 256, spacing), spacing);
      // The points that there were all have one near them.
      for (std::uint32_t p = 0; p <= before.parts(); ++p) {
        std::uint32_t nearest = weight_one;
        for (std::uint32_t q = 0; q <= after.parts(); ++q) {
          const std::uint32_t a = before.place(p), b = after.place(q);
          nearest = std::min(nearest, a > b ? a - b : b - a);
        }
        EXPECT_LE(nearest, 70u) << i / 256.0;
      }
      before = after;
    }
  }
}

}  // namespace
}  // namespace foredraw::edge_division_test
