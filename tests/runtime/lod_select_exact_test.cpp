// foredraw_lod_select() beside the best choices, and beside the best where ways may be mixed, both exact.

#include "runtime/lod_instances.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace foredraw::testing::lod_select_exact_test {
namespace {

/// What holds of every choice. `best` is the most benefit within the budget.
void check(const std::vector<Ways>& objects, std::uint64_t budget, const Choice& choice,
           std::optional<std::uint64_t> best) {
  const auto [least_cost, least_benefit] = least_of(objects);
  ASSERT_TRUE(choice.adds_up());
  ASSERT_EQ(choice.result.is_over != 0, !best.has_value());
  if (!best) {  // all are there, and cheap
    ASSERT_EQ(choice.result.cost, least_cost);
    ASSERT_EQ(choice.result.benefit, least_benefit);
    ASSERT_EQ(choice.result.bound, least_benefit);
    return;
  }
  ASSERT_LE(choice.result.cost, budget);
  ASSERT_LE(choice.result.benefit, *best);
  ASSERT_GE(choice.result.bound, *best);
  ASSERT_GE(2 * (choice.result.benefit - least_benefit), *best - least_benefit);
}

/// Whether no two objects have steps that gain alike.
bool is_without_ties(const std::vector<Ways>& objects, std::uint64_t budget) {
  const Flat flat(objects);
  const foredraw_lod_scene scene = flat.scene();
  std::vector<std::uint32_t> chosen(scene.objects);
  std::vector<foredraw_lod_step> steps(scene.first[scene.objects]);
  foredraw_lod_result least;
  foredraw_lod_begin(&scene, chosen.data(), &least);
  steps.resize(foredraw_lod_steps(&scene, chosen.data(), budget - least.cost, steps.data()));
  std::set<std::pair<std::uint32_t, std::uint32_t>> gains;
  std::set<std::pair<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>>> own;
  for (const foredraw_lod_step& step : steps) {
    const std::uint32_t common = std::gcd(step.cost, step.benefit);
    const std::pair gain(step.benefit / common, step.cost / common);
    if (own.emplace(step.object, gain).second && !gains.insert(gain).second) return false;
  }
  return true;
}

TEST(LodSelectExact, TenThousandInstances) {
  Random random(1);
  int over = 0, whole = 0, mixed = 0, best_found = 0, with_budget = 0;
  for (int round = 0; round < 10000; ++round) {
    SCOPED_TRACE(round);
    const std::vector<Ways> objects = drawn_objects(random, 12, 4);
    const std::uint64_t budget = drawn_budget(objects, random);
    const std::optional<std::uint64_t> best = best_of(objects, budget);
    if (objects.size() <= 5) {
      ASSERT_EQ(best, best_by_trying(objects, budget));
    }
    const Choice choice = selected(objects, budget);
    ASSERT_NO_FATAL_FAILURE(check(objects, budget, choice, best));
    if (!best) {
      ++over;
      continue;
    }
    // No more than a unit above what ways that are mixed could show, and never below.
    const cpp_rational of_mixed = best_of_mixed(affordable(objects, budget), budget);
    ASSERT_EQ(cpp_int(choice.result.bound), rounded_up(of_mixed));
    ASSERT_LE(of_mixed, best_of_mixed(objects, budget));
    ++(denominator(of_mixed) == 1 ? whole : mixed);
    ++with_budget;
    best_found += choice.result.benefit == *best;
  }
  EXPECT_GT(over, 500);
  EXPECT_GT(whole, 1000);
  EXPECT_GT(mixed, 1000);
  EXPECT_GT(best_found * 100, with_budget * 80);
  RecordProperty("best_found_percent", best_found * 100 / with_budget);
}

/// Hundreds of objects: steps are told apart by the histogram, and most of them tie.
TEST(LodSelectExact, ManyObjectsWithFewCosts) {
  Random random(2);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    std::vector<Ways> objects(600);
    const std::uint64_t benefits = round % 2 ? 4 : 1000;
    for (Ways& ways : objects) {
      for (std::uint32_t w = 0; w < 4; ++w) {
        ways.push_back(
            {static_cast<std::uint32_t>(random.below(6)), static_cast<std::uint32_t>(random.below(benefits))});
      }
      std::ranges::sort(ways, {}, &foredraw_lod_way::benefit);
    }
    const std::uint64_t least = least_of(objects).first, budget = least + random.below(1500);
    const Choice choice = selected(objects, budget);
    ASSERT_NO_FATAL_FAILURE(check(objects, budget, choice, best_by_costs(objects, budget)));
    ASSERT_EQ(cpp_int(choice.result.bound), rounded_up(best_of_mixed(affordable(objects, budget), budget)));
  }
}

/// All that 32 bits hold.
TEST(LodSelectExact, LargestNumbers) {
  Random random(3);
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    std::vector<Ways> objects(1 + random.below(6));
    for (Ways& ways : objects) {
      for (std::size_t n = 1 + random.below(4); n > 0; --n) {
        const auto number = [&] {
          return random.below(2) ? static_cast<std::uint32_t>(UINT32_MAX - random.below(3))
                                 : static_cast<std::uint32_t>(random.next() >> (32 + random.below(32)));
        };
        const std::uint32_t cost = number();
        ways.push_back({cost, number()});
      }
    }
    const std::uint64_t budget = drawn_budget(objects, random);
    const Choice choice = selected(objects, budget);
    const std::optional<std::uint64_t> best = best_of(objects, budget);
    ASSERT_NO_FATAL_FAILURE(check(objects, budget, choice, best));
    if (best) {
      ASSERT_EQ(cpp_int(choice.result.bound), rounded_up(best_of_mixed(affordable(objects, budget), budget)));
    }
  }
}

TEST(LodSelectExact, WaysMayComeInAnySequence) {
  Random random(4);
  for (int round = 0; round < 3000; ++round) {
    SCOPED_TRACE(round);
    std::vector<Ways> objects = drawn_objects(random, 8, 6);
    const std::uint64_t budget = drawn_budget(objects, random);
    const Choice choice = selected(objects, budget);
    for (int other = 0; other < 3; ++other) {
      for (Ways& ways : objects) {
        if (other == 0) std::ranges::sort(ways, {}, &foredraw_lod_way::cost);
        if (other == 1) std::ranges::reverse(ways);
        if (other == 2) shuffle(ways, random);
      }
      const Choice same = selected(objects, budget);
      ASSERT_TRUE(alike(same.ways, choice.ways));  // each object is drawn alike
      ASSERT_EQ(same.result.bound, choice.result.bound);
    }
  }
}

/// The bound is the same in any sequence of objects, and where no two objects gain alike, so is each object's way.
/// Where they do, the object that comes first is served first.
TEST(LodSelectExact, ObjectsMayComeInAnySequenceButForTies) {
  Random random(5);
  int without_ties = 0, with_ties = 0, other_choices = 0;
  for (int round = 0; round < 5000; ++round) {
    SCOPED_TRACE(round);
    const std::vector<Ways> objects = drawn_objects(random, 10, 4);
    const std::uint64_t budget = drawn_budget(objects, random);
    std::vector<std::size_t> sequence(objects.size());
    std::iota(sequence.begin(), sequence.end(), 0);
    shuffle(sequence, random);
    std::vector<Ways> moved;
    for (const std::size_t object : sequence) moved.push_back(objects[object]);
    const Choice choice = selected(objects, budget), other = selected(moved, budget);
    ASSERT_EQ(other.result.is_over, choice.result.is_over);
    ASSERT_EQ(other.result.bound, choice.result.bound);
    ASSERT_NO_FATAL_FAILURE(check(moved, budget, other, best_of(moved, budget)));
    bool is_same = true;
    for (std::size_t i = 0; i < sequence.size(); ++i)
      is_same = is_same && alike(other.ways[i], choice.ways[sequence[i]]);
    if (choice.result.is_over || is_without_ties(objects, budget)) {
      ASSERT_TRUE(is_same);
      ++without_ties;
    } else {
      ++with_ties;
      other_choices += !is_same;
    }
  }
  EXPECT_GT(without_ties, 1000);
  EXPECT_GT(with_ties, 500);
  EXPECT_GT(other_choices, 100);
}

/// Objects without ways change nothing, wherever they stand.
TEST(LodSelectExact, ObjectsWithoutWaysAreNotDrawn) {
  Random random(6);
  for (int round = 0; round < 2000; ++round) {
    SCOPED_TRACE(round);
    const std::vector<Ways> objects = drawn_objects(random, 6, 4);
    const std::uint64_t budget = drawn_budget(objects, random);
    std::vector<Ways> with_empty;
    for (const Ways& ways : objects) {
      with_empty.resize(with_empty.size() + random.below(4));
      with_empty.push_back(ways);
    }
    with_empty.resize(with_empty.size() + random.below(4));
    const Choice choice = selected(objects, budget), other = selected(with_empty, budget);
    ASSERT_TRUE(alike(other.ways, choice.ways));
    ASSERT_EQ(other.result.cost, choice.result.cost);
    ASSERT_EQ(other.result.benefit, choice.result.benefit);
    ASSERT_EQ(other.result.bound, choice.result.bound);
    for (std::size_t i = 0; i < with_empty.size(); ++i) {
      if (with_empty[i].empty()) {
        ASSERT_EQ(other.chosen[i], 0u);
      }
    }
  }
}

}  // namespace
}  // namespace foredraw::testing::lod_select_exact_test
