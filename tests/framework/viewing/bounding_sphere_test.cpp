#include <foredraw/viewing/bounding_sphere.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foredraw::bounding_sphere_test {
namespace {

TEST(BoundingSphere, holds_what_is_drawn_and_finite) {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec3> positions = {{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {100, 0, 0}, {infinity, 0, 0}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 1, 4};
  const DrawnPositions part{positions, indices};
  const BoundingSphere sphere = bounding_sphere({&part, 1});
  EXPECT_EQ(sphere.centre, glm::dvec3(2, 1, 0));
  EXPECT_EQ(sphere.radius, std::sqrt(5.0));
}

TEST(BoundingSphere, spans_all_parts) {
  const std::vector<glm::vec3> left = {{-3, 0, 0}};
  const std::vector<glm::vec3> right = {{5, 0, 0}};
  const std::vector<std::uint32_t> first = {0};
  const std::vector<DrawnPositions> parts = {{left, first}, {right, first}};
  EXPECT_EQ(bounding_sphere(parts).centre, glm::dvec3(1, 0, 0));
  EXPECT_EQ(bounding_sphere(parts).radius, 4);
}

TEST(BoundingSphere, of_nothing_is_a_point) {
  EXPECT_EQ(bounding_sphere({}).centre, glm::dvec3(0));
  EXPECT_EQ(bounding_sphere({}).radius, 0);
}

TEST(BoundingSphere, the_largest_floats_do_not_overflow) {
  const float most = std::numeric_limits<float>::max();
  const std::vector<glm::vec3> positions = {{-most, -most, -most}, {most, most, most}};
  const std::vector<std::uint32_t> indices = {0, 1};
  const DrawnPositions part{positions, indices};
  EXPECT_NEAR(bounding_sphere({&part, 1}).radius / most, std::sqrt(3.0), 1e-12);
}

}  // namespace
}  // namespace foredraw::bounding_sphere_test
