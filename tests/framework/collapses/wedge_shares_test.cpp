#include <foredraw/collapses/wedge_shares.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foredraw::wedge_shares_test {
namespace {

/// Around the edge from (0, 0) to (1, 0), bent upwards beside it: ten triangles with eight corners around.
struct Star {
  std::vector<glm::vec3> corners{{0, 0, 0},        {1, 0, 0},  {2, 0, 0},         {1.5f, 0.9f, 0},  {0.5f, 0.9f, 0},
                                 {-0.5f, 0.9f, 0}, {-1, 0, 0}, {-0.5f, -0.9f, 0}, {0.5f, -0.9f, 0}, {1.5f, -0.9f, 0}};
  std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 4}, {1, 0, 8}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7},
                                                  {0, 7, 8}, {1, 3, 4}, {1, 2, 3}, {1, 9, 2}, {1, 8, 9}};

  std::vector<WedgeShare> at(glm::vec3 place) const {
    WedgeShares shares;
    shares.start(place);
    for (const auto& face : faces) shares.add({corners[face[0]], corners[face[1]], corners[face[2]]}, face);
    const auto found = shares.finish();
    return {found.begin(), found.end()};
  }
};

TEST(WedgeShares, SayWhatIsLinearExactly) {
  const Star star;
  const auto slope = [&](std::uint32_t v) { return 3.0 * star.corners[v].x - 2.0 * star.corners[v].y + 7; };
  for (const glm::vec3 place : {glm::vec3(0.5f, 0, 0), {0.1f, 0.3f, 0}, {0.7f, -0.2f, 0}}) {
    const auto shares = star.at(place);
    double sum = 0;
    for (const WedgeShare& one : shares) sum += one.share;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(shared_number(std::span<const WedgeShare>(shares), slope), 3 * place.x - 2 * place.y + 7, 1e-6);
  }
}

/// Where a surface lies above the planes of its faces, what they say is read straight below.
TEST(WedgeShares, HeightMakesNoDifference) {
  const auto flat = Star().at({0.5f, 0.1f, 0}), above = Star().at({0.5f, 0.1f, 0.4f});
  ASSERT_EQ(flat.size(), above.size());
  for (std::size_t i = 0; i < flat.size(); ++i) EXPECT_NEAR(flat[i].share, above[i].share, 1e-12);
}

/// The value at which squared differences from all faces, by area, are least: to move it either way costs more.
TEST(WedgeShares, AreTheLeastSquares) {
  const Star star;
  const glm::dvec3 place(0.4, 0.1, 0);
  const auto value = [&](std::uint32_t v) { return std::sin(2.0 * star.corners[v].x) + 0.5 * star.corners[v].y; };
  const auto cost = [&](double is) {
    double sum = 0;
    for (const auto& face : star.faces) {
      const auto at = [&](std::size_t k) { return glm::dvec3(star.corners[face[k]]); };
      const auto twice = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      };
      const double area = twice(at(0), at(1), at(2));
      const double says = (twice(place, at(1), at(2)) * value(face[0]) + twice(at(0), place, at(2)) * value(face[1]) +
                           twice(at(0), at(1), place) * value(face[2])) /
                          area;
      sum += std::abs(area) * (is - says) * (is - says);
    }
    return sum;
  };
  const auto shares = star.at(place);
  const double found = shared_sum(std::span<const WedgeShare>(shares), value);
  EXPECT_LT(cost(found), cost(found + 0.01));
  EXPECT_LT(cost(found), cost(found - 0.01));
}

TEST(WedgeShares, NumbersStayBetweenThoseOfTheCorners) {
  const auto shares = Star().at({0.5f, 0, 0});
  const auto peak = [](std::uint32_t v) { return v < 2 ? 1.0 : 0.0; };
  EXPECT_GT(shared_sum(std::span<const WedgeShare>(shares), peak), 1.0);
  EXPECT_EQ(shared_number(std::span<const WedgeShare>(shares), peak), 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(
      shared_number(std::span<const WedgeShare>(shares), [&](std::uint32_t v) { return v == 5 ? nan : 1.0; })));
}

TEST(WedgeShares, AreNoneWhereFacesDoNotSay) {
  EXPECT_TRUE(Star().at({60, 0, 0}).empty()) << "so far away differences would be blown up";
  WedgeShares shares;
  shares.start({0.5f, 0, 0});
  EXPECT_TRUE(shares.finish().empty());
  const std::array<std::uint32_t, 3> vertices{0, 1, 2};
  shares.add({glm::vec3(0), {1, 0, 0}, {2, 0, 0}}, vertices);
  shares.add({glm::vec3(0), {1, 0.001f, 0}, {2, 0, 0}}, vertices);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  shares.add({glm::vec3(0), {1, nan, 0}, {2, 0, 0}}, vertices);
  EXPECT_TRUE(shares.finish().empty()) << "narrow ones, and what is no number";
  shares.start({0.5f, 0.5f, 0});
  for (std::size_t i = 0; i <= WedgeShares::most_faces; ++i) shares.add({glm::vec3(0), {1, 0, 0}, {0, 1, 0}}, vertices);
  EXPECT_TRUE(shares.finish().empty());
}

}  // namespace
}  // namespace foredraw::wedge_shares_test
