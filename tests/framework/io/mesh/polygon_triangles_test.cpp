#include <foredraw/io/mesh/private/polygon_mesh.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numeric>

namespace foredraw::mesh_files::polygon_triangles_test {
namespace {

struct Cut {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t earless = 0, unfinished = 0;
  double area = 0;        ///< of all triangles that wind as the polygon does
  bool all_alike = true;  ///< all wind so
};

Cut cut(const std::vector<glm::vec3>& points, glm::vec3 up = {0, 0, 1}) {
  Cut result;
  Triangulator triangulator(points.size());
  triangulator.cut(points, result.triangles);
  result.earless = triangulator.earless();
  result.unfinished = triangulator.unfinished();
  for (const auto& [a, b, c] : result.triangles) {
    const float area = glm::dot(glm::cross(points[b] - points[a], points[c] - points[a]), up) / 2;
    result.all_alike = result.all_alike && area > 0;
    result.area += area;
  }
  return result;
}

TEST(PolygonTriangles, AConvexOneIsAFanAroundItsFirstCorner) {
  const Cut pentagon = cut({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}});
  EXPECT_EQ(pentagon.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(PolygonTriangles, AQuadThatPointsInwardsIsCutAtThatCorner) {
  for (std::size_t turn = 0; turn < 4; ++turn) {
    std::vector<glm::vec3> dart{{0, 0, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, 0}};
    std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(turn), dart.end());
    const Cut made = cut(dart);
    EXPECT_EQ(made.triangles.size(), 2u);
    EXPECT_TRUE(made.all_alike) << turn;
    EXPECT_NEAR(made.area, 4, 1e-6);
  }
}

TEST(PolygonTriangles, CombsInAnyPlaneKeepTheirArea) {
  for (const int teeth : {3, 40, 400}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<glm::vec3> comb;
      const auto add = [&](float x, float y) {
        glm::vec3 p(0);
        p[(axis + 1) % 3] = x;
        p[(axis + 2) % 3] = y;
        comb.push_back(p);
      };
      add(static_cast<float>(2 * teeth), -1);
      for (int i = teeth; i-- > 0;) {
        add(static_cast<float>(2 * i + 2), 0);
        add(static_cast<float>(2 * i + 1), 10);
      }
      add(0, 0);
      add(0, -1);
      glm::vec3 up(0);
      up[axis] = 1;
      const Cut made = cut(comb, up);
      EXPECT_EQ(made.triangles.size(), comb.size() - 2);
      EXPECT_EQ(made.earless + made.unfinished, 0u);
      EXPECT_TRUE(made.all_alike);
      EXPECT_NEAR(made.area, 2 * teeth + 10 * teeth, 1e-3);
    }
  }
}

TEST(PolygonTriangles, WhateverThePointsThereAreTwoTrianglesLess) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.size(), 2u);
  const Cut nothing = cut(std::vector<glm::vec3>(7, glm::vec3(1)));
  EXPECT_EQ(nothing.triangles.size(), 5u);
  EXPECT_EQ(nothing.earless, 1u);
  EXPECT_EQ(nothing.unfinished, 0u);
  const Cut straight = cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_TRUE(straight.all_alike) << "a corner on a straight line makes no triangle without area";
  EXPECT_NEAR(straight.area, 4, 1e-6);
}

/// A star of so many corners, every second one of which points inwards.
std::vector<glm::vec3> star(std::size_t corners) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = i % 2 == 0 ? 1000 : 500;
    points.emplace_back(static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)), 0);
  }
  return points;
}

TEST(PolygonTriangles, LargeOnesAreFinishedAndTooLargeOnesAreSaidToBeSo) {
  const Cut large = cut(star(10'000));
  EXPECT_EQ(large.earless + large.unfinished, 0u);
  EXPECT_TRUE(large.all_alike);
  const Cut too_large = cut(star(30'000));
  EXPECT_EQ(too_large.earless, 0u) << "it has an ear as long as it has corners";
  EXPECT_EQ(too_large.unfinished, 1u);
}

TEST(PolygonTriangles, WhatIsConvexTakesNoWork) {
  const auto points = star(30'000);
  Triangulator triangulator(points.size() + 5);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangulator.cut(points, triangles);
  const std::vector<glm::vec3> pentagon{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}};
  triangulator.cut(pentagon, triangles);
  EXPECT_EQ(triangulator.unfinished(), 1u);
  const std::vector<glm::vec3> dart{{0, 0, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, 0}};
  triangulator.cut(dart, triangles);
  EXPECT_EQ(triangulator.unfinished(), 2u) << "the work is that of the file";
}

TEST(PolygonTriangles, TheWorkIsBounded) {
  // A spiral staircase of spikes: few ears, and many corners that point inwards. More work than the bound would be
  // hours.
  std::vector<glm::vec3> spikes;
  std::uint32_t state = 1;
  for (int i = 0; i < 200'000; ++i) {
    state = state * 1664525u + 1013904223u;
    spikes.emplace_back(static_cast<float>(state >> 16), static_cast<float>(state & 0xffff), 0);
  }
  EXPECT_EQ(cut(spikes).triangles.size(), spikes.size() - 2);
}

}  // namespace
}  // namespace foredraw::mesh_files::polygon_triangles_test
