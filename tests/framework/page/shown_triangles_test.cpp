#include <foredraw/page/shown_triangles.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::shown_triangles_test {
namespace {

/// A sheet of so many squares each way.
struct Sheet {
  explicit Sheet(int squares) {
    for (int y = 0; y <= squares; ++y) {
      for (int x = 0; x <= squares; ++x) positions.emplace_back(x, y, 0);
    }
    const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (squares + 1) + x); };
    for (int y = 0; y < squares; ++y) {
      for (int x = 0; x < squares; ++x) {
        indices.insert(indices.end(), {at(x, y), at(x + 1, y), at(x, y + 1)});
        indices.insert(indices.end(), {at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      }
    }
  }
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

TEST(ShownTriangles, AreAllOfAFewInTheirOwnOrder) {
  const Sheet sheet(4);
  const ShownTriangles shown = shown_triangles(sheet.positions, sheet.indices, 32);
  EXPECT_EQ(shown.triangles.size(), 32u);
  EXPECT_EQ(shown.indices, sheet.indices);
  EXPECT_EQ(shown.vertices.size(), 25u);
}

TEST(ShownTriangles, OfManyAreNoMoreThanAskedFor) {
  const Sheet sheet(100);
  for (const std::size_t most : {1000u, 5000u, 19999u}) {
    const ShownTriangles shown = shown_triangles(sheet.positions, sheet.indices, most);
    EXPECT_LE(shown.triangles.size(), most);
    EXPECT_GE(shown.triangles.size(), most / 8);
    EXPECT_TRUE(std::is_sorted(shown.triangles.begin(), shown.triangles.end()));
    double area = 0;  // the sheet is still whole
    for (std::size_t t = 0; t < shown.triangles.size(); ++t) {
      const auto corner = [&](std::size_t i) { return sheet.positions[shown.vertices[shown.indices[3 * t + i]]]; };
      const glm::vec3 a = corner(1) - corner(0), b = corner(2) - corner(0);
      area += std::abs(a.x * b.y - a.y * b.x) / 2;
    }
    EXPECT_GT(area, 0.85 * 100 * 100);
  }
}

/// Those that cover nothing go first where there are too many.
TEST(ShownTriangles, HaveFiniteCorners) {
  Sheet sheet(2);
  sheet.positions[0].x = std::numeric_limits<float>::quiet_NaN();
  sheet.positions[8].y = std::numeric_limits<float>::infinity();
  sheet.indices.insert(sheet.indices.end(), {3, 3, 4});
  EXPECT_EQ(shown_triangles(sheet.positions, sheet.indices, 7).triangles,
            (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 8}));
  EXPECT_EQ(shown_triangles(sheet.positions, sheet.indices, 6).triangles,
            (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6}));
}

TEST(ShownTriangles, FoundOnceAreTheSame) {
  const Sheet sheet(100), smaller(90);
  ShownTrianglesOnce once;
  for (const Sheet* one : {&sheet, &smaller, &sheet}) {
    for (const std::size_t most : {1000u, 5000u, 30000u}) {
      const ShownTriangles found = once.of(one->positions, one->indices, most);
      const ShownTriangles searched = shown_triangles(one->positions, one->indices, most);
      EXPECT_EQ(found.triangles, searched.triangles);
      EXPECT_EQ(found.indices, searched.indices);
      EXPECT_EQ(found.vertices, searched.vertices);
    }
  }
}

TEST(ShownTriangles, OfNothingAreNone) {
  EXPECT_TRUE(shown_triangles({}, {}, 10).triangles.empty());
  const Sheet sheet(1);
  EXPECT_TRUE(shown_triangles(sheet.positions, {}, 10).vertices.empty());
}

TEST(ShownTriangles, OfPointsInOnePlaceStayFew) {
  const std::vector<glm::vec3> positions(300, glm::vec3(1, 2, 3));
  std::vector<std::uint32_t> indices(300);
  for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
  EXPECT_LE(shown_triangles(positions, indices, 10).triangles.size(), 10u);
}

}  // namespace
}  // namespace foredraw::shown_triangles_test
