// foredraw_crowd_select() beside the best choices, beside foredraw_lod_select(), and beside the paper's formula.

#include "runtime/crowds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace foredraw::testing::crowd_select_exact_test {
namespace {

/// The least sum of squares within the budget, by trying all.
double least_squares(const std::vector<foredraw_crowd_level>& levels, std::span<const float> distances,
                     std::uint64_t budget) {
  if (distances.empty()) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const foredraw_crowd_level& level : levels) {
    if (level.triangles > budget) continue;
    const double off = static_cast<double>(level.error) / static_cast<double>(distances[0]);
    least = std::min(least, off * off + least_squares(levels, distances.subspan(1), budget - level.triangles));
  }
  return least;
}

/// Distances are those where buckets begin, so that they are told apart exactly.
TEST(CrowdSelectExact, IsWithinAStepOfTheBest) {
  Random random(1);
  int best_found = 0, within_budget = 0;
  for (int round = 0; round < 3000; ++round) {
    SCOPED_TRACE(round);
    std::vector<foredraw_crowd_level> levels;
    for (std::uint64_t i = 1 + random.below(5); i > 0; --i) {
      levels.push_back({static_cast<std::uint32_t>(random.below(40)), static_cast<float>(random.unit())});
    }
    std::vector<float> distances(1 + random.below(5));
    for (float& distance : distances) distance = 1 + static_cast<float>(random.below(128)) / 128;
    const std::uint64_t budget = random.below(150);
    CrowdChooser chooser(levels);
    const foredraw_crowd_result result = chooser.choose(distances, budget);
    ASSERT_EQ(result.triangles, chooser.triangles());
    const double best = least_squares(levels, distances, budget), found = chooser.squares(distances);
    ASSERT_EQ(result.is_over != 0, std::isinf(best));
    if (result.is_over != 0) continue;
    ASSERT_LE(result.triangles, budget);
    double step = 0;  // the most that one gains
    for (std::uint32_t s = 0; s < chooser.table().steps; ++s) {
      const auto squared = [&](std::uint32_t steps) {
        return std::pow(static_cast<double>(levels[chooser.table().hull[steps]].error), 2);
      };
      step = std::max(step, squared(s) - squared(s + 1));
    }
    const auto nearest = static_cast<double>(*std::ranges::min_element(distances));
    ASSERT_LE(found - best, step / (nearest * nearest) + 1e-7);
    ++within_budget;
    best_found += found - best < 1e-7;
  }
  EXPECT_GT(within_budget, 2000);
  EXPECT_GT(2 * best_found, within_budget);
}

/// The general solver, which knows nothing of buckets of distances or of prices.
TEST(CrowdSelectExact, IsTheChoiceOfLodSelect) {
  for (const std::uint32_t n : {20u, 300u, 5000u}) {
    const std::vector<float> distances = crowd_distances(n, n);
    CrowdChooser chooser(froblin_levels());
    const std::uint64_t budget = 10ull * 337 * 5160;
    chooser.choose(distances, budget);
    std::vector<foredraw_lod_way> ways;
    std::vector<std::uint32_t> first{0}, chosen(n);
    for (const float distance : distances) {
      for (const foredraw_crowd_level& level : chooser.levels()) {
        const double off = static_cast<double>(level.error) / static_cast<double>(distance);
        ways.push_back({level.triangles, static_cast<std::uint32_t>((65 - off * off) * 6e7)});
      }
      first.push_back(static_cast<std::uint32_t>(ways.size()));
    }
    const foredraw_lod_scene scene{n, first.data(), ways.data()};
    std::vector<std::uint64_t> memory(foredraw_lod_memory(&scene) / 8 + 1);
    foredraw_lod_select(&scene, budget, chosen.data(), memory.data());
    double squares = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double off = static_cast<double>(chooser.levels()[chosen[i]].error) / static_cast<double>(distances[i]);
      squares += off * off;
    }
    EXPECT_LT(std::sqrt(chooser.squares(distances) / squares), 1.005) << n;
  }
}

struct Methods {
  double paper = 0, root = 0, ours = 0;  ///< sums of squares
};

Methods squares_of(std::uint32_t n, std::uint64_t seed) {
  const std::vector<float> distances = crowd_distances(n, seed);
  CrowdChooser chooser(tessellated_levels(15));
  chooser.choose(distances, 3370);
  double weights = 0;
  for (const float d : distances) weights += 1 / (static_cast<double>(d) * static_cast<double>(d));
  const auto of = [&](float level) {
    const double whole = foredraw_tessellation_floor(level, FOREDRAW_SPACING_EQUAL);
    return weights / (whole * whole);
  };
  return {of(foredraw_tessellation_by_count(10, 15, n)), of(foredraw_tessellation_by_root(10, 15, n)),
          chooser.squares(distances)};
}

/// Means over eight crowds.
TEST(CrowdSelectExact, IsOffByAFractionOfThePapersFormula) {
  struct Row {
    std::uint32_t n;
    double of_paper, of_root;
  };
  for (const auto& [n, of_paper, of_root] : {Row{50, 0.40, 0.85}, Row{200, 0.26, 0.75}, Row{1000, 0.62, 0.62}}) {
    Methods sum;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Methods one = squares_of(n, seed);
      sum.paper += one.paper;
      sum.root += one.root;
      sum.ours += one.ours;
    }
    EXPECT_LE(std::sqrt(sum.ours / sum.paper), of_paper) << n;
    EXPECT_LE(std::sqrt(sum.ours / sum.root), of_root) << n;
  }
}

/// Without and with the last frame's levels, which are those of the crowd with one fewer.
void check_budget(const std::vector<std::uint32_t>& crowds) {
  const std::uint64_t budget = 10ull * 337 * 5160;
  CrowdChooser fresh(froblin_levels()), kept(froblin_levels());
  std::vector<float> all = crowd_distances(crowds.back(), 5);
  Random random(6);
  for (const std::uint32_t n : crowds) {
    const std::span<const float> distances(all.data(), n);
    const std::uint64_t triangles = fresh.choose(distances, budget).triangles;
    const std::uint64_t with_last = kept.choose(distances, budget, 0.35f).triangles;
    ASSERT_EQ(triangles, fresh.triangles()) << n;
    ASSERT_EQ(with_last, kept.triangles()) << n;
    ASSERT_LE(triangles, budget) << n;
    ASSERT_LE(with_last, budget) << n;
    if (n >= 10) {
      ASSERT_GE(static_cast<double>(triangles), 0.98 * static_cast<double>(budget)) << n;
      ASSERT_GE(static_cast<double>(with_last), 0.98 * static_cast<double>(budget)) << n;
    }
    all[random.below(n)] = crowd_distances(1, n)[0];
  }
}

/// Everybody flies on a straight line through the camera and through all others, so that distances fall to 0 and grow
/// again, and all are at one place in the middle of it.
TEST(CrowdBudget, HoldsForACrowdThatFliesThroughItself) {
  constexpr std::uint32_t instances = 1000;
  constexpr int frames = 201;
  Random random(23);
  std::vector<float> from(instances);
  for (float& distance : from) distance = static_cast<float>(2 + 38 * random.unit());
  for (const float hysteresis : {0.0f, 0.35f}) {
    CrowdChooser chooser(froblin_levels());
    const std::uint64_t budget = 10ull * 337 * 5160;
    for (int frame = 0; frame < frames; ++frame) {
      const float way = static_cast<float>(2 * frame) / (frames - 1) - 1;  // -1 to 1, and 0 in the middle
      std::vector<float> distances;
      for (const float distance : from) distances.push_back(std::abs(way) * distance);
      const foredraw_crowd_result result = chooser.choose(distances, budget, hysteresis);
      ASSERT_EQ(result.unplaced, 0u) << frame;
      ASSERT_EQ(result.is_over, 0) << frame;
      ASSERT_EQ(result.triangles, chooser.triangles()) << frame;
      ASSERT_LE(result.triangles, budget) << frame;
      ASSERT_GE(result.triangles * 100, budget * (hysteresis > 0 ? 90 : 98)) << frame;
    }
  }
}

TEST(CrowdBudget, HoldsAndIsUsedForManyCrowds) {
  std::vector<std::uint32_t> crowds;
  for (std::uint32_t n = 1; n < 200'000; n += 1 + n / 20) crowds.push_back(n);
  crowds.push_back(200'000);
  check_budget(crowds);
}

/// Minutes.
TEST(CrowdBudget, LongHoldsAndIsUsedForEveryCrowd) {
  std::vector<std::uint32_t> crowds(200'000);
  for (std::uint32_t n = 0; n < crowds.size(); ++n) crowds[n] = n + 1;
  check_budget(crowds);
}

/// What the formulas take of the same budget: each crowd of more than M Tmax^2 is drawn beyond it.
TEST(CrowdBudget, DoesNotHoldByThePapersFormula) {
  std::uint32_t over = 0;
  for (std::uint32_t n = 1; n <= 200'000; ++n) {
    const float level = foredraw_tessellation_by_count(10, 15, n);
    const std::uint64_t taken =
        std::uint64_t{n} * foredraw_tessellation_triangles(foredraw_tessellation_floor(level, FOREDRAW_SPACING_EQUAL));
    over += taken > 3370;
    EXPECT_EQ(taken > 3370, n > 3370) << n;
  }
  EXPECT_EQ(over, 200'000u - 3370u);
}

}  // namespace
}  // namespace foredraw::testing::crowd_select_exact_test
