// Our nearest points against CGAL's. Where CGAL is not found this is not built.

#include <foredraw/analysis/closest_points.h>

#include "support/meshes.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <vector>

namespace foredraw::closest_points_cgal_test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>>>;

Kernel::Point_3 exact(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// Distances to a surface whose numbers are exact, rounded once.
void expect_equal_distances(const testing::TestMesh& mesh) {
  Triangles triangles;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t c) { return exact(glm::dvec3(mesh.positions[mesh.indices[i + c]])); };
    const Kernel::Triangle_3 triangle(corner(0), corner(1), corner(2));
    if (!triangle.is_degenerate()) triangles.push_back(triangle);  // beside others, no point is nearest on these alone
  }
  Tree tree(triangles.begin(), triangles.end());
  const ClosestPoints ours({mesh.positions, mesh.indices});
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 point = 4.0 * glm::dvec3{random.unit(), random.unit(), random.unit()} - 2.0;
    const double theirs = std::sqrt(CGAL::to_double(tree.squared_distance(exact(point))));
    const Closest closest = ours.nearest(point);
    EXPECT_NEAR(closest.distance, theirs, 1e-12);
    EXPECT_NEAR(std::sqrt(CGAL::to_double(CGAL::squared_distance(exact(point), exact(closest.point)))), theirs, 1e-12);
  }
}

TEST(ClosestPointsByCgal, OfATorusAreEqual) { expect_equal_distances(testing::torus(40, 24)); }

TEST(ClosestPointsByCgal, OfRandomTrianglesAreEqual) { expect_equal_distances(testing::soup(1000, 7)); }

TEST(ClosestPointsByCgal, OfASphereWithPointsForTrianglesAtItsPolesAreEqual) {
  expect_equal_distances(testing::sphere(24, 16));
}

}  // namespace
}  // namespace foredraw::closest_points_cgal_test
