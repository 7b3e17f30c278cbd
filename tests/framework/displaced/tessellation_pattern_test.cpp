#include <foredraw/base/random.h>
#include <foredraw/displaced/tessellation_pattern.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

namespace foredraw::tessellation_pattern_test {
namespace {

using enum TessellationSpacing;

constexpr TessellationSpacing spacings[] = {equal, fractional_odd, fractional_even};

TessellationLevels all(float level) { return {{level, level, level}, level}; }

TessellationLevels random_levels(Random& random) {
  const auto level = [&] { return static_cast<float>(random.unit() < 0.5 ? 1 + random.below(8) : 65 * random.unit()); };
  return {{level(), level(), level()}, level()};
}

TEST(TessellationPattern, has_as_many_triangles_as_vulkan_gives) {
  const std::map<float, std::size_t> counts = {{1, 1},  {2, 6},  {3, 13},   {4, 24},     {5, 37},   {6, 54},
                                               {7, 73}, {8, 96}, {16, 384}, {12.5, 253}, {64, 6144}};
  for (const auto& [level, count] : counts) {
    EXPECT_EQ(tessellation_pattern(all(level), equal).triangles.size(), count) << level;
  }
  for (std::uint32_t level = 1; level <= 64; ++level) {
    EXPECT_EQ(tessellation_counts(all(static_cast<float>(level)), equal).triangles, 3 * level * level / 2);
  }
  EXPECT_EQ(tessellation_pattern(all(16), fractional_odd).triangles.size(), 433u);
}

TEST(TessellationPattern, is_counted_without_being_made) {
  Random random(1);
  for (const TessellationSpacing spacing : spacings) {
    for (int i = 0; i < 500; ++i) {
      const TessellationLevels levels = random_levels(random);
      const TessellationPattern pattern = tessellation_pattern(levels, spacing);
      EXPECT_EQ(tessellation_counts(levels, spacing),
                (TessellationCounts{static_cast<std::uint32_t>(pattern.points.size()),
                                    static_cast<std::uint32_t>(pattern.triangles.size())}));
    }
  }
}

TEST(TessellationPattern, levels_that_are_none) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  for (const TessellationSpacing spacing : spacings) {
    const float least = spacing == fractional_even ? 2 : 1;
    for (const float bad : {0.0f, -3.0f, none}) {
      for (std::size_t e = 0; e < 3; ++e) {
        TessellationLevels levels = all(5);
        levels.outer[e] = bad;
        EXPECT_TRUE(tessellation_pattern(levels, spacing).points.empty());
        EXPECT_TRUE(tessellation_pattern(levels, spacing).triangles.empty());
        EXPECT_EQ(effective_levels(levels, spacing), all(0));
        EXPECT_EQ(tessellation_counts(levels, spacing), TessellationCounts{});
      }
      EXPECT_EQ(effective_levels({{least, least, least}, bad}, spacing), all(least));  // an inner one culls nothing
    }
    EXPECT_EQ(effective_levels(all(1e30f), spacing), all(spacing == fractional_odd ? 63 : 64));
  }
  EXPECT_EQ(effective_levels({{1, 3, 1}, 1}, equal), (TessellationLevels{{1, 3, 1}, 2}));
  EXPECT_EQ(effective_levels({{1, 3, 1}, 1}, fractional_odd), (TessellationLevels{{1, 3, 1}, 1 + 1.0f / 65536}));
  EXPECT_EQ(effective_levels({{1, 1, 1}, 7}, equal), (TessellationLevels{{1, 1, 1}, 7}));
}

TEST(TessellationPattern, effective_levels_stay_as_they_are) {
  Random random(2);
  for (const TessellationSpacing spacing : spacings) {
    for (int i = 0; i < 2000; ++i) {
      const TessellationLevels levels = effective_levels(random_levels(random), spacing);
      EXPECT_EQ(effective_levels(levels, spacing), levels);
    }
  }
}

TEST(TessellationPattern, covers_the_triangle_once) {
  Random random(3);
  for (const TessellationSpacing spacing : spacings) {
    for (int i = 0; i < 300; ++i) {
      const TessellationLevels levels = random_levels(random);
      const TessellationPattern pattern = tessellation_pattern(levels, spacing);
      std::set<std::pair<int, int>> sides;
      std::set<int> used;
      std::int64_t area = 0, least = 1;
      for (const auto& triangle : pattern.triangles) {
        std::array<std::int64_t, 3> u{}, v{};
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_TRUE(sides.emplace(triangle[c], triangle[(c + 1) % 3]).second);
          used.insert(triangle[c]);
          u[c] = pattern.points[triangle[c]].u;
          v[c] = pattern.points[triangle[c]].v;
        }
        const std::int64_t twice = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
        area += twice;
        least = std::min(least, twice);
      }
      EXPECT_EQ(used.size(), pattern.points.size());
      EXPECT_EQ(area, std::int64_t{weight_one} * weight_one);
      EXPECT_GE(least, -std::int64_t{weight_one}) << "but for rounding none is turned over";
      std::size_t outline = 0;
      for (const auto& [from, to] : sides) {
        if (sides.contains({to, from})) continue;
        ++outline;
        const auto a = pattern.points[static_cast<std::size_t>(from)].weights();
        const auto b = pattern.points[static_cast<std::size_t>(to)].weights();
        EXPECT_TRUE((a[0] == 0 && b[0] == 0) || (a[1] == 0 && b[1] == 0) || (a[2] == 0 && b[2] == 0));
      }
      std::size_t parts = 0;
      const TessellationLevels effective = effective_levels(levels, spacing);
      for (const float level : effective.outer) {
        if (level > 0) parts += EdgeDivision(level, spacing).parts();
      }
      EXPECT_EQ(outline, parts);
    }
  }
}

TEST(TessellationPattern, points_on_an_edge_lie_where_its_own_division_says) {
  Random random(4);
  for (const TessellationSpacing spacing : spacings) {
    for (int i = 0; i < 300; ++i) {
      const TessellationLevels levels = effective_levels(random_levels(random), spacing);
      if (levels.inner == 0) continue;
      const TessellationPattern pattern = tessellation_pattern(levels, spacing);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(pattern.points[c].weights()[c], weight_one);
      std::size_t point = 3;
      for (std::size_t e = 0; e < 3; ++e) {
        const EdgeDivision edge(levels.outer[e], spacing);
        for (std::uint32_t p = 1; p < edge.parts(); ++p, ++point) {
          const auto weights = pattern.points[point].weights();
          EXPECT_EQ(weights[e], 0u);
          EXPECT_EQ(weights[(e + 2) % 3], edge.place(p));
        }
      }
      for (; point < pattern.points.size(); ++point) {
        EXPECT_LE(pattern.points[point].u + pattern.points[point].v, weight_one);
      }
    }
  }
}

TEST(TessellationPattern, coordinates_are_exact) {
  for (const TessellationPoint& point : tessellation_pattern(all(37.3f), fractional_odd).points) {
    const auto [u, v, w] = point.coordinates();
    EXPECT_EQ(u * 65536, static_cast<float>(point.u));
    EXPECT_EQ(1.0f - u - v, w);
  }
}

}  // namespace
}  // namespace foredraw::tessellation_pattern_test
