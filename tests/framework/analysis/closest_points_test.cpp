#include <foredraw/analysis/closest_points.h>

#include "support/collapses.h"
#include "support/meshes.h"

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>

namespace foredraw::closest_points_test {
namespace {

using testing::TestMesh;

Surface surface_of(const TestMesh& mesh) { return {mesh.positions, mesh.indices}; }

glm::dvec3 any_point(Random& random) { return {3 * random.unit() - 1, 3 * random.unit() - 1, 3 * random.unit() - 1}; }

/// By trying every triangle, the first one of those that are equally near.
Closest by_trying_all(const ClosestPoints& points, const glm::dvec3& point) {
  std::uint32_t best = 0;
  for (std::uint32_t t = 1; t < points.size(); ++t) {
    if (squared_distance(points.corners(t), point) < squared_distance(points.corners(best), point)) best = t;
  }
  Closest result = closest_on(points.corners(best), point);
  result.triangle = best;
  return result;
}

/// The distance to a triangle by many points of its own: the true one or a little more.
double by_many_points(const TriangleCorners& t, const glm::dvec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  constexpr int steps = 60;
  for (int u = 0; u <= steps; ++u) {
    for (int v = 0; u + v <= steps; ++v) {
      const glm::dvec3 at = t[0] + (t[1] - t[0]) * (u / double{steps}) + (t[2] - t[0]) * (v / double{steps});
      nearest = std::min(nearest, glm::length(at - point));
    }
  }
  return nearest;
}

void expect_same(const Closest& a, const Closest& b) {
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.weights, b.weights);
}

TEST(ClosestOn, IsNoFartherThanAnyPointOfTheTriangle) {
  const TestMesh mesh = testing::soup(60, 3);
  const ClosestPoints triangles(surface_of(mesh));
  Random random(5);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 5; ++i) {
      const glm::dvec3 point = any_point(random);
      const Closest found = closest_on(triangles.corners(t), point);
      const double tried = by_many_points(triangles.corners(t), point);
      EXPECT_LE(found.distance, tried + 1e-12);
      EXPECT_GT(found.distance, tried - 0.06);
      EXPECT_NEAR(glm::length(found.point - point), found.distance, 1e-12);
    }
  }
}

TEST(ClosestOn, WeightsSayWhereThePointIs) {
  const TriangleCorners corners{glm::dvec3{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Closest found = closest_on(corners, any_point(random));
    double sum = 0;
    glm::dvec3 mean(0);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(found.weights[c], 0);
      sum += found.weights[c];
      mean += found.weights[c] * corners[static_cast<std::size_t>(c)];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_NEAR(glm::length(mean - found.point), 0, 1e-14);
  }
}

TEST(ClosestOn, OfATriangleThatIsALineOrAPoint) {
  const TriangleCorners line{glm::dvec3{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_DOUBLE_EQ(closest_on(line, {1.5, 2, 0}).distance, 2);
  EXPECT_DOUBLE_EQ(closest_on(line, {3, 0, 0}).distance, 1);
  const TriangleCorners point{glm::dvec3{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  EXPECT_DOUBLE_EQ(closest_on(point, {1, 1, 4}).distance, 3);
}

/// A plane through corners so near a line is hardly known; the distance is that of a point of the triangle all the
/// same.
TEST(ClosestOn, OfAThinTriangleIsNotThatOfItsPlane) {
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const TriangleCorners thin{glm::dvec3{0, 0, 0}, {1, 1, 0}, {0.5 - width, 0.5 + width, width}};
    const Closest found = closest_on(thin, {0.25, 0.25, 1});
    EXPECT_NEAR(found.distance, 1, width);
    EXPECT_NEAR(found.point.x, 0.25, width);
  }
}

TEST(ClosestPoints, FindsWhatTryingAllFinds) {
  for (const TestMesh& mesh :
       {testing::soup(300, 3), testing::sphere(24, 16), testing::grid(9, 7), testing::spokes(200)}) {
    const ClosestPoints closest(surface_of(mesh));
    Random random(5);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 point = any_point(random);
      expect_same(closest.nearest(point), by_trying_all(closest, point));
    }
    for (const glm::vec3& corner : mesh.positions) {
      expect_same(closest.nearest(glm::dvec3(corner)), by_trying_all(closest, glm::dvec3(corner)));
    }
  }
}

TEST(ClosestPoints, AHintChangesNoAnswer) {
  const TestMesh mesh = testing::torus(30, 20);
  const ClosestPoints closest(surface_of(mesh));
  Random random(9);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 point = i % 2 == 0 ? any_point(random) : glm::dvec3(mesh.positions[random.below(600)]);
    const auto hint = static_cast<std::uint32_t>(random.below(2 * closest.size()));
    expect_same(closest.nearest(point, hint), closest.nearest(point));
  }
}

/// Squares of such coordinates are no floats.
TEST(ClosestPoints, OfAnySize) {
  const TestMesh mesh = testing::soup(200, 11);
  const ClosestPoints closest(surface_of(mesh));
  Random random(2);
  for (const float scale : {0x1p-100f, 0x1p100f}) {
    TestMesh scaled = mesh;
    for (glm::vec3& p : scaled.positions) p *= scale;
    const ClosestPoints of_scaled(surface_of(scaled));
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 point = any_point(random);
      const Closest found = of_scaled.nearest(point * double{scale});
      EXPECT_EQ(found.triangle, closest.nearest(point).triangle);
      EXPECT_EQ(found.distance, closest.nearest(point).distance * scale);
    }
    EXPECT_NEAR(of_scaled.distance(glm::dvec3(1e30, 0, 0) * double{scale}) / scale, 1e30, 1e15);
  }
}

/// The mesh lies where neighbouring floats are a thousandth of the surface apart.
TEST(ClosestPoints, FarFromTheOriginTheyAreFound) {
  TestMesh far = testing::sphere(200, 100);
  for (glm::vec3& at : far.positions) at += glm::vec3(8192, -8192, 8192);
  const ClosestPoints points(surface_of(far));
  Random random(9);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 point = any_point(random) + glm::dvec3(8192, -8192, 8192);
    expect_same(points.nearest(point), by_trying_all(points, point));
  }
}

TEST(ClosestPoints, LeavesOutWhatIsNotFinite) {
  TestMesh mesh = testing::joined(testing::grid(1, 1), testing::grid(1, 1));
  for (std::size_t v = 0; v < 4; ++v) mesh.positions[v].y = std::numeric_limits<float>::infinity();
  const ClosestPoints closest(surface_of(mesh));
  EXPECT_EQ(closest.nearest({0.25, 0.25, 1}).triangle, 2u);
  EXPECT_EQ(closest.nearest({0.25, 0.25, 1}, 0).triangle, 2u);
  mesh.indices.resize(6);
  const ClosestPoints none(surface_of(mesh));
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.nearest({0, 0, 0}).triangle, no_triangle);
  EXPECT_EQ(none.distance({0, 0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace foredraw::closest_points_test
