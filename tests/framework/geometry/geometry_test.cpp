#include <foredraw/geometry/box.h>
#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/geometry/triangle_area.h>

#include <glm/vec2.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::geometry_test {
namespace {

TEST(Box, is_empty_until_something_is_added) {
  Box<glm::dvec3> box;
  EXPECT_TRUE(box.is_empty());
  EXPECT_EQ(box.extent(), glm::dvec3(0));
  box.add(Box<glm::dvec3>());
  EXPECT_TRUE(box.is_empty());
  box.add({1, 2, 3});
  EXPECT_FALSE(box.is_empty());
  EXPECT_EQ(box.diagonal(), 0);
}

TEST(Box, holds_points_and_boxes) {
  Box<glm::vec2> box{{0, 1}, {1, 2}};
  box.add({-1, 5});
  box.add(Box<glm::vec2>{{0, 0}, {2, 1}});
  EXPECT_EQ(box.min, glm::vec2(-1, 0));
  EXPECT_EQ(box.max, glm::vec2(2, 5));
  EXPECT_EQ(box.extent(), glm::vec2(3, 5));
}

TEST(Finite, looks_at_every_element) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite(glm::vec2(0, -1e38f)));
  for (int i = 0; i < 3; ++i) {
    for (const double number : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
      glm::dvec3 vector(1);
      vector[i] = number;
      EXPECT_FALSE(is_finite(vector));
      glm::dmat4x3 matrix(1);
      EXPECT_TRUE(is_finite(matrix));
      matrix[3][i] = number;
      EXPECT_FALSE(is_finite(matrix));
    }
  }
}

TEST(JoinedSets, are_named_by_their_smallest_member) {
  JoinedSets sets(5);
  sets.join(4, 3);
  sets.join(1, 4);
  EXPECT_EQ(sets.of(3), 1u);
  EXPECT_EQ(sets.of(4), 1u);
  EXPECT_EQ(sets.of(0), 0u);
  EXPECT_EQ(sets.of(2), 2u);
}

TEST(TriangleArea, is_half_of_the_parallelogram) { EXPECT_EQ(triangle_area({1, 1, 1}, {4, 1, 1}, {1, 3, 1}), 3); }

}  // namespace
}  // namespace foredraw::geometry_test
