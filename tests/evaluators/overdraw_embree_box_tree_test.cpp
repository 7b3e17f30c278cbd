#include "../../evaluators/overdraw_embree/box_tree.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace foredraw::overdraw_embree_box_tree_test {
namespace {

TEST(BoxTree, finds_the_boxes_that_a_ray_meets) {
  std::vector<Box<glm::vec3>> boxes;
  for (int i = 0; i < 100; ++i)
    boxes.push_back({glm::vec3(i % 10, i / 10, i) * 0.1f, glm::vec3(i % 10 + 1, i / 10 + 1, i + 1) * 0.1f});
  const EmbreeBoxTree tree(boxes);
  std::vector<std::uint32_t> met;
  tree.for_each_met({{0.45f, 0.75f, -1}, {0, 0, 1}, 20}, [&](std::uint32_t i) { met.push_back(i); });
  EXPECT_EQ(met, std::vector<std::uint32_t>{74});
  met.clear();
  tree.for_each_met({{0.45f, 0.75f, -1}, {0, 0, 1}, 5}, [&](std::uint32_t i) { met.push_back(i); });
  EXPECT_TRUE(met.empty());
  EXPECT_THROW(
      tree.for_each_met({{0.45f, 0.75f, -1}, {0, 0, 1}, 20}, [](std::uint32_t) { throw std::out_of_range("x"); }),
      std::out_of_range);
  EmbreeBoxTree({}).for_each_met({{0, 0, 0}, {0, 0, 1}, 1}, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace foredraw::overdraw_embree_box_tree_test
