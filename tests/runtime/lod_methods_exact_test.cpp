// What the methods of Funkhouser and Sequin 1993 promise, beside the best choices.

#include "runtime/lod_instances.h"

#include <benchmarks/lod_select/lod_methods.h>

#include <gtest/gtest.h>

namespace foredraw::testing::lod_methods_exact_test {
namespace {

Choice by_value(const std::vector<Ways>& objects, std::uint64_t budget) {
  return Flat(objects).choose([&](const foredraw_lod_scene* scene, std::uint32_t* chosen) {
    std::vector<std::uint32_t> memory(2 * scene->first[scene->objects]);
    return foredraw_lod_by_value(scene, budget, chosen, memory.data());
  });
}

Choice from_last(const std::vector<Ways>& objects, std::uint64_t budget, std::vector<std::uint32_t> last,
                 std::uint32_t* rounds = nullptr) {
  return Flat(objects).choose(
      [&](const foredraw_lod_scene* scene, std::uint32_t* chosen) {
        std::vector<std::uint32_t> memory(4 * scene->objects);
        return foredraw_lod_from_last(scene, budget, chosen, memory.data(), rounds);
      },
      std::move(last));
}

/// The most benefit of a way within the budget.
std::uint64_t largest_way(const std::vector<Ways>& objects, std::uint64_t budget) {
  std::uint64_t largest = 0;
  for (const Ways& ways : objects) {
    for (const foredraw_lod_way& way : ways) {
      if (way.cost <= budget) largest = std::max<std::uint64_t>(largest, way.benefit);
    }
  }
  return largest;
}

TEST(LodByValue, ReachesHalfButForAWayWhereObjectsMayBeFree) {
  Random random(1);
  int below_half = 0;
  for (int round = 0; round < 10000; ++round) {
    SCOPED_TRACE(round);
    std::vector<Ways> objects = drawn_objects(random, 12, 3);
    for (Ways& ways : objects) ways.push_back({0, static_cast<std::uint32_t>(random.below(2) * random.below(4))});
    const std::uint64_t budget = drawn_budget(objects, random);
    const Choice choice = by_value(objects, budget);
    const std::uint64_t best = best_of(objects, budget).value();
    ASSERT_TRUE(choice.adds_up());
    ASSERT_LE(choice.result.cost, budget);
    ASSERT_LE(choice.result.benefit, best);
    ASSERT_GE(2 * choice.result.benefit + largest_way(objects, budget), best);
    below_half += 2 * choice.result.benefit < best;
  }
  EXPECT_GT(below_half, 0);  // so the one way must be there
}

/// The plain knapsack, as the paper has it: an object is drawn in one way, or not. Half is reached where no way takes
/// more than half of the budget.
TEST(LodByValue, ReachesHalfWhereNoWayTakesMoreThanHalfOfTheBudget) {
  Random random(2);
  for (int round = 0; round < 5000; ++round) {
    SCOPED_TRACE(round);
    std::vector<Ways> objects = drawn_objects(random, 14, 1);
    std::uint64_t largest = 0;
    for (Ways& ways : objects) {
      largest = std::max<std::uint64_t>(largest, ways[0].cost);
      ways.insert(ways.begin() + static_cast<std::ptrdiff_t>(random.below(2)), {0, 0});
    }
    const std::uint64_t budget = 2 * largest + random.below(2 * largest + 1);
    ASSERT_GE(2 * by_value(objects, budget).result.benefit, best_of(objects, budget).value());
  }
}

/// Without that, a way that gains a little more for its cost keeps out one that is worth all.
TEST(LodByValue, MayMissNearlyEverythingOtherwise) {
  const std::vector<Ways> objects{{{0, 0}, {1, 2}}, {{0, 0}, {1000, 1000}}};
  EXPECT_EQ(by_value(objects, 1000).result.benefit, 2u);
  EXPECT_EQ(selected(objects, 1000).result.benefit, 1000u);
}

/// A way that costs nothing and is worth nothing has no value; it must not part those that have one.
TEST(LodByValue, AWayOfNothingDoesNotStandBetweenOthers) {
  const std::vector<Ways> objects{{{3, 1}, {0, 0}}, {{0, 0}, {3, 9}}, {{0, 0}, {3, 5}}};
  EXPECT_EQ(by_value(objects, 3).result.benefit, 9u);
  EXPECT_EQ(by_value(objects, 6).result.benefit, 14u);
}

TEST(LodByValue, TakesNoDearerWayOfTheSameBenefit) {
  const std::vector<Ways> objects{{{0, 0}, {1, 5}, {3, 5}}, {{0, 0}, {2, 1}}};
  EXPECT_EQ(by_value(objects, 3).result.cost, 3u);
  EXPECT_EQ(by_value(objects, 3).result.benefit, 6u);
  EXPECT_EQ(by_value(objects, 2).result.cost, 1u);
}

/// Ways from the cheapest to the best, each better and dearer.
std::vector<Ways> rising(Random& random, std::size_t most_objects) {
  std::vector<Ways> objects = drawn_objects(random, most_objects, 5);
  for (Ways& ways : objects) {
    std::vector<std::uint32_t> costs, benefits;
    for (const foredraw_lod_way& way : ways) {
      costs.push_back(way.cost);
      benefits.push_back(way.benefit);
    }
    std::ranges::sort(costs);
    std::ranges::sort(benefits);
    for (std::size_t w = 0; w < ways.size(); ++w) ways[w] = {costs[w], benefits[w]};
  }
  return objects;
}

TEST(LodFromLast, EndsAndKeepsTheBudget) {
  Random random(3);
  for (int round = 0; round < 10000; ++round) {
    SCOPED_TRACE(round);
    const std::vector<Ways> objects = rising(random, 12);
    std::uint64_t least = 0, ways = 0;
    std::vector<std::uint32_t> last;
    for (const Ways& own : objects) {
      least += own.front().cost;
      ways += own.size();
      last.push_back(static_cast<std::uint32_t>(random.below(own.size())));
    }
    const std::uint64_t budget = drawn_budget(objects, random);
    std::uint32_t rounds = 0;
    const Choice choice = from_last(objects, budget, last, &rounds);
    ASSERT_TRUE(choice.adds_up());
    ASSERT_LE(rounds, ways);
    ASSERT_EQ(choice.result.is_over != 0, budget < least);
    if (budget >= least) {
      ASSERT_LE(choice.result.cost, budget);
    } else {
      ASSERT_EQ(choice.result.cost, least);
    }
  }
}

/// The same objects with and without a way that lies far below the upper hull. What stands behind it is found by
/// chance.
TEST(LodFromLast, ComesNearTheBestOnHullsAlone) {
  Random random(4);
  double raw = 0, on_hulls = 0, least = 1;
  constexpr int rounds = 100;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Ways> objects(200), hulls;
    std::uint64_t most = 0;
    for (Ways& ways : objects) {
      const auto triangles = static_cast<std::uint32_t>(10 + random.below(1000));
      const std::uint32_t size = 1u << random.below(11);
      ways = {{triangles, 1}, {6 * triangles, 2}, {8 * triangles, 100 * size}, {16 * triangles, 150 * size}};
      hulls.push_back({ways[0], ways[2], ways[3]});
      most += ways.back().cost;
    }
    const std::uint64_t budget = most * (15 + random.below(30)) / 100;
    const auto bound = static_cast<double>(selected(objects, budget).result.bound);
    const double part = static_cast<double>(from_last(hulls, budget, {}).result.benefit) / bound;
    raw += static_cast<double>(from_last(objects, budget, {}).result.benefit) / bound;
    on_hulls += part;
    least = std::min(least, part);
  }
  EXPECT_LT(raw / rounds, 0.6);
  EXPECT_GT(on_hulls / rounds, 0.98);
  EXPECT_GT(least, 0.9);
  RecordProperty("raw_percent", static_cast<int>(100 * raw / rounds));
  RecordProperty("on_hulls_percent", static_cast<int>(100 * on_hulls / rounds));
}

/// A budget that is spent to the last is no reason to stop: ways are still exchanged.
TEST(LodFromLast, GoesOnWhereTheBudgetIsSpentExactly) {
  const std::vector<Ways> objects{{{1, 1}, {2, 2}}, {{1, 1}, {2, 2}}, {{1, 1}, {2, 10}}, {{1, 1}, {2, 9}}};
  const Choice choice = from_last(objects, 6, {1, 1, 0, 0});
  EXPECT_EQ(choice.result.benefit, 21u);
  EXPECT_EQ(choice.result.cost, 6u);
}

/// A hundred objects whose second way is little worth, and ten whose third is worth most but stands behind a second
/// that is bad value. It takes the hundred, then one bad way, which does not fit and has the lowest value of all: the
/// end.
TEST(LodFromLast, StopsFarBelowTheBestAtABadStep) {
  std::vector<Ways> objects(100, Ways{{1, 1}, {2, 2}});
  objects.resize(110, Ways{{1, 1}, {100, 2}, {101, 1000}});
  const std::uint64_t budget = 260;
  EXPECT_EQ(from_last(objects, budget, {}).result.benefit, 210u);
  EXPECT_EQ(best_by_costs(objects, budget), 1159u);
  EXPECT_EQ(selected(objects, budget).result.benefit, 1159u);
  for (std::size_t i = 100; i < 110; ++i) objects[i].erase(objects[i].begin() + 1);  // the hull
  EXPECT_EQ(from_last(objects, budget, {}).result.benefit, 1109u);
}

TEST(LodMethods, ObjectsWithoutWaysAndChoicesThatAreGone) {
  const std::vector<Ways> objects{{}, {{1, 1}, {2, 3}}, {}, {{1, 2}}, {}};
  EXPECT_EQ(by_value(objects, 3).result.benefit, 5u);
  EXPECT_EQ(from_last(objects, 3, {7, 7, 7, 7, 7}).result.benefit, 5u);
  EXPECT_EQ(from_last(objects, 2, {7, 7, 7, 7, 7}).result.benefit, 3u);
  EXPECT_EQ(from_last({{}, {}}, 2, {}).result.cost, 0u);
}

}  // namespace
}  // namespace foredraw::testing::lod_methods_exact_test
