#include <foredraw/analysis/part_boxes.h>

#include "support/collapses.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::part_boxes_test {
namespace {

using Sliver = std::array<glm::vec3, 3>;

bool holds(const BoxTree::Box& box, const glm::dvec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < double{box.min[axis]} || point[axis] > double{box.max[axis]}) return false;
  }
  return true;
}

glm::vec3 any_corner(Random& random, double size) {
  const auto any = [&] { return static_cast<float>(size * (2 * random.unit() - 1)); };
  return {any(), any(), any()};
}

/// From one corner to two that are beside each other.
Sliver any_sliver(Random& random, double size) {
  const glm::vec3 tip = any_corner(random, size), end = any_corner(random, size);
  return {tip, end, end + any_corner(random, size * std::pow(2.0, -3.0 - 20 * random.unit()))};
}

TEST(PartBoxes, TogetherHoldEveryPoint) {
  Random random(4);
  for (int i = 0; i < 400; ++i) {
    const Sliver t = any_sliver(random, std::pow(2.0, 40 * random.unit() - 40));
    const glm::dvec3 a(t[0]), b(t[1]), c(t[2]);
    std::vector<BoxTree::Box> boxes;
    add_part_boxes(t, 2 + random.below(15), boxes);
    for (int k = 0; k < 200; ++k) {
      const double u = random.unit(), v = (1 - u) * (k % 3 == 0 ? 0 : random.unit());
      const glm::dvec3 point = a + u * (b - a) + v * (c - a);
      EXPECT_TRUE(std::ranges::any_of(boxes, [&](const auto& box) { return holds(box, point); })) << i;
    }
    for (const glm::vec3& corner : t) {
      EXPECT_TRUE(std::ranges::any_of(boxes, [&](const auto& box) { return holds(box, glm::dvec3(corner)); }));
    }
  }
}

TEST(PartBoxes, OneIsTheTrianglesOwn) {
  std::vector<BoxTree::Box> boxes;
  add_part_boxes({glm::vec3(0, 1, 2), glm::vec3(3, -1, 5), glm::vec3(1, 1, 1)}, 1, boxes);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].min, glm::vec3(0, -1, 1));
  EXPECT_EQ(boxes[0].max, glm::vec3(3, 1, 5));
}

TEST(PartBoxes, AreForWhatIsThinAndLiesAcrossTheAxes) {
  const auto worth = [](glm::vec3 a, glm::vec3 b, glm::vec3 c) { return boxes_worth_having({a, b, c}); };
  EXPECT_EQ(worth({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1u);
  EXPECT_EQ(worth({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1u) << "as large as its box lets it be";
  EXPECT_EQ(worth({0, 0, 0}, {1, 0, 0}, {1, 1e-6f, 0}), 1u) << "along an axis its box is as thin";
  EXPECT_EQ(worth({0, 0, 0}, {1, 1, 0}, {1, 1.0625f, 0}), 4u);
  EXPECT_EQ(worth({0, 0, 0}, {1, 1, 0}, {1, 1.000001f, 0}), 16u);
  EXPECT_EQ(worth({0, 0, 0}, {1, 1, 0}, {0.5f, 0.5f, 0}), 16u) << "a line";
  EXPECT_EQ(worth({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 1u) << "a point";
}

/// Around a hub a point of the surface lies in a sixth of all boxes, but in few of their parts.
TEST(PartBoxes, OfAHubHoldFewOfItsPoints) {
  const testing::TestMesh hub = testing::spokes(2000);
  std::vector<BoxTree::Box> whole, parts;
  for (std::size_t i = 0; i < hub.indices.size(); i += 3) {
    const Sliver t{hub.positions[hub.indices[i]], hub.positions[hub.indices[i + 1]], hub.positions[hub.indices[i + 2]]};
    add_part_boxes(t, 1, whole);
    add_part_boxes(t, boxes_worth_having(t), parts);
  }
  std::ptrdiff_t in_whole = 0, in_parts = 0;
  for (std::size_t i = 0; i < hub.indices.size(); i += 300) {
    glm::dvec3 middle(0);
    for (std::size_t c = 0; c < 3; ++c) middle += glm::dvec3(hub.positions[hub.indices[i + c]]) / 3.0;
    const auto is_in = [&](const BoxTree::Box& box) { return holds(box, middle); };
    in_whole += std::ranges::count_if(whole, is_in);
    in_parts += std::ranges::count_if(parts, is_in);
  }
  EXPECT_LT(8 * in_parts, in_whole);
}

}  // namespace
}  // namespace foredraw::part_boxes_test
