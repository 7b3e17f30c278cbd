#include "plugins/processors/merge_instances/spatial_groups.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::processors::merge_instances::merge_instances_groups_test {
namespace {

PlacedBox placed(const glm::vec3& middle, float half, std::uint32_t indices) {
  PlacedBox result;
  result.box.add(middle - glm::vec3(half));
  result.box.add(middle + glm::vec3(half));
  result.indices = indices;
  return result;
}

std::vector<PlacedBox> town(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto unit = [&] { return static_cast<float>(random.unit()); };
  const float side = 4 * std::sqrt(static_cast<float>(count));
  std::vector<PlacedBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 middle{unit() * side, unit(), unit() * side};
    const float half = 1 + unit();
    boxes.push_back(placed(middle, half, static_cast<std::uint32_t>(30 + random.below(1500))));
  }
  return boxes;
}

void expect_each_once(const SpatialGroups& groups, std::span<const PlacedBox> boxes) {
  std::vector<std::uint32_t> seen = groups.instances;
  std::ranges::sort(seen);
  ASSERT_EQ(seen.size(), boxes.size());
  for (std::uint32_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    EXPECT_FALSE(groups.of(g).empty());
    EXPECT_TRUE(std::ranges::is_sorted(groups.of(g)));
    Box<glm::vec3> bound;
    for (const std::uint32_t i : groups.of(g)) bound.add(boxes[i].box);
    EXPECT_EQ(bound.min, groups.bounds[g].min);
    EXPECT_EQ(bound.max, groups.bounds[g].max);
  }
}

TEST(MergeGroups, TheFrustumsMeasuresAreThoseOfItsPyramid) {
  const double y = std::tan(std::acos(-1.0) / 6), x = y * 16 / 9;
  EXPECT_NEAR(SeenBoxes::frustum_volume, 4 * x * y / 3, 1e-9);
  const double slant_y = std::sqrt(1 + y * y), slant_x = std::sqrt(1 + x * x);
  EXPECT_NEAR(SeenBoxes::frustum_surface, 4 * x * y + 2 * x * slant_y + 2 * y * slant_x, 1e-9);
  const double edges = 4 * x * std::acos(-y / slant_y) + 4 * y * std::acos(-x / slant_x) +
                       4 * std::sqrt(1 + x * x + y * y) * std::acos(x * y / (slant_x * slant_y));
  EXPECT_NEAR(SeenBoxes::frustum_curvature, edges / 2, 1e-9);
}

TEST(MergeGroups, EveryInstanceIsInOneGroupWithATightBound) {
  const std::vector<PlacedBox> boxes = town(3000, 3);
  const SpatialGroups groups = spatial_groups(boxes, {.draw_cost = 2000}, Executor(2));
  EXPECT_GT(groups.size(), 4u);
  expect_each_once(groups, boxes);
  EXPECT_EQ(groups.cost.draws, groups.size());
}

TEST(MergeGroups, CostLessThanTheBestGridOneDrawAndManyDraws) {
  std::vector<PlacedBox> boxes = town(2000, 4);
  for (const PlacedBox& far_off : town(500, 5)) {  // a suburb beside it, denser
    boxes.push_back(far_off);
    boxes.back().box.min = boxes.back().box.min * 0.2f + glm::vec3(400, 30, 90);
    boxes.back().box.max = boxes.back().box.max * 0.2f + glm::vec3(400, 30, 90);
  }
  const GroupOptions options{.draw_cost = 3000};
  const SpatialGroups groups = spatial_groups(boxes, options, Executor(2));
  expect_each_once(groups, boxes);
  EXPECT_LE(groups.cost.total(3000), groups.before_merging.total(3000));
  EXPECT_LT(groups.cost.total(3000), 0.97 * best_grid(boxes, options).total(3000));
  EXPECT_LT(groups.cost.total(3000), 3000.0 * static_cast<double>(boxes.size()));
  std::printf("groups %zu: cost %.0f, before merging %.0f, best grid %.0f of %llu cells\n", groups.size(),
              groups.cost.total(3000), groups.before_merging.total(3000), best_grid(boxes, options).total(3000),
              static_cast<unsigned long long>(best_grid(boxes, options).draws));
}

/// No other grouping of a few boxes is much better: all of them are tried.
TEST(MergeGroups, AreNearTheBestOfAllGroupings) {
  double sum = 0, best_sum = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<PlacedBox> boxes = town(8, 20 + seed);
    const GroupOptions options{.draw_cost = 200};
    Box<glm::vec3> scene;
    for (const PlacedBox& box : boxes) scene.add(box.box);
    const SpatialGroups groups = spatial_groups(boxes, options, Executor(1));
    const SeenBoxes seen(scene, groups.view_distance);
    double best = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> group_of(boxes.size(), 0);
    const auto try_all = [&](auto&& self, std::size_t next, std::size_t used) -> void {
      if (next < boxes.size()) {
        for (std::size_t g = 0; g <= used && g < boxes.size(); ++g) {
          group_of[next] = g;
          self(self, next + 1, std::max(used, g + 1));
        }
        return;
      }
      double cost = 0;
      for (std::size_t g = 0; g < used; ++g) {
        Box<glm::vec3> bound;
        double indices = 0, own = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          if (group_of[i] != g) continue;
          bound.add(boxes[i].box);
          indices += boxes[i].indices;
          own += seen(boxes[i].box) * boxes[i].indices;
        }
        cost += options.draw_cost + seen(bound) * indices - own;
      }
      best = std::min(best, cost);
    };
    try_all(try_all, 0, 0);
    EXPECT_GE(groups.cost.total(200), best * (1 - 1e-9));
    sum += groups.cost.total(200);
    best_sum += best;
  }
  std::printf("against the best groupings: %.3f\n", sum / best_sum);
  EXPECT_LT(sum, 1.1 * best_sum);
}

TEST(MergeGroups, KeepTheBudgets) {
  const std::vector<PlacedBox> boxes = town(1000, 6);
  const GroupOptions options{.draw_cost = 1e9, .most_indices = 20'000, .most_instances = 30, .most_size = 25};
  const SpatialGroups groups = spatial_groups(boxes, options, Executor(2));
  expect_each_once(groups, boxes);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::uint64_t indices = 0;
    for (const std::uint32_t i : groups.of(g)) indices += boxes[i].indices;
    EXPECT_LE(indices, 20'000u);
    EXPECT_LE(groups.of(g).size(), 30u);
    const glm::vec3 side = groups.bounds[g].max - groups.bounds[g].min;
    if (groups.of(g).size() > 1) EXPECT_LE(std::max({side.x, side.y, side.z}), 25);
  }
  const GroupOptions large{.draw_cost = 1e9, .most_indices = 20'000, .most_instances = 30};
  EXPECT_LT(spatial_groups(boxes, large, Executor(2)).size(), groups.size());
}

TEST(MergeGroups, BoxesInOnePlaceAreOneGroup) {
  const std::vector<PlacedBox> boxes(5000, placed({1, 2, 3}, 1, 30));
  EXPECT_EQ(spatial_groups(boxes, {}, Executor(2)).size(), 1u);
  const GroupOptions few{.most_instances = 100};
  const SpatialGroups groups = spatial_groups(boxes, few, Executor(2));
  expect_each_once(groups, boxes);
  EXPECT_LE(groups.size(), 64u);
}

TEST(MergeGroups, NothingAndPointsAreGroupedToo) {
  EXPECT_EQ(spatial_groups({}, {}, Executor(1)).size(), 0u);
  const std::vector<PlacedBox> points(3, placed({0, 0, 0}, 0, 3));
  EXPECT_EQ(spatial_groups(points, {}, Executor(1)).size(), 1u);
}

TEST(MergeGroups, RefuseBoxesThatAreNotFinite) {
  std::vector<PlacedBox> boxes(2, placed({0, 0, 0}, 1, 3));
  boxes[1].box.max.y = std::numeric_limits<float>::infinity();
  EXPECT_THROW(spatial_groups(boxes, {}, Executor(1)), std::invalid_argument);
  boxes[1].box = {};
  EXPECT_THROW(spatial_groups(boxes, {}, Executor(1)), std::invalid_argument);
}

TEST(MergeGroups, AHundredThousandAreTheSameOnTwoThreads) {
  const std::vector<PlacedBox> boxes = town(100'000, 7);
  const Executor executor(2);
  const SpatialGroups groups = spatial_groups(boxes, {}, executor);
  const SpatialGroups alone = spatial_groups(boxes, {}, Executor(1));
  EXPECT_EQ(groups.instances, alone.instances);
  EXPECT_EQ(groups.first, alone.first);
  EXPECT_EQ(groups.cost.wasted, alone.cost.wasted);
}

}  // namespace
}  // namespace foredraw::processors::merge_instances::merge_instances_groups_test
