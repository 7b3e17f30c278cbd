// What surface-error says, against CGAL's exact distances of points that are spread by this file alone. Where CGAL is
// not found this is not built.
#include "evaluators/surface_error/surface_error.h"

#include "support/meshes.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foredraw::surface_error_cgal_test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>>>;
using testing::TestMesh;

glm::dvec3 corner(const TestMesh& mesh, std::size_t at) { return glm::dvec3(mesh.positions[mesh.indices[at]]); }

struct Distances {
  double mean_square = 0, standard_error = 0, largest = 0;
};

/// From points of one surface, evenly by area, to the other.
Distances by_cgal(const TestMesh& from, const TestMesh& to, int samples) {
  Triangles triangles;
  for (std::size_t i = 0; i < to.indices.size(); i += 3) {
    const auto exact = [](const glm::dvec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    const Kernel::Triangle_3 one(exact(corner(to, i)), exact(corner(to, i + 1)), exact(corner(to, i + 2)));
    if (!one.is_degenerate()) triangles.push_back(one);
  }
  const Tree tree(triangles.begin(), triangles.end());
  std::vector<double> areas;
  double sum = 0;
  for (std::size_t i = 0; i < from.indices.size(); i += 3) {
    sum += glm::length(glm::cross(corner(from, i + 1) - corner(from, i), corner(from, i + 2) - corner(from, i)));
    areas.push_back(sum);
  }
  Random random(77);
  double squares = 0, fourths = 0;
  Distances found;
  for (int s = 0; s < samples; ++s) {
    const auto t = std::ranges::upper_bound(areas, random.unit() * sum) - areas.begin();
    const std::size_t at = 3 * std::min(static_cast<std::size_t>(t), areas.size() - 1);
    const double root = std::sqrt(random.unit()), part = random.unit();
    const glm::dvec3 point =
        (1 - root) * corner(from, at) + root * (1 - part) * corner(from, at + 1) + root * part * corner(from, at + 2);
    const double squared = CGAL::to_double(tree.squared_distance(Kernel::Point_3(point.x, point.y, point.z)));
    squares += squared;
    fourths += squared * squared;
    found.largest = std::max(found.largest, std::sqrt(squared));
  }
  found.mean_square = squares / samples;
  found.standard_error = std::sqrt(std::max(fourths / samples - found.mean_square * found.mean_square, 0.0) / samples);
  return found;
}

void expect_what_cgal_says(const OneWayError& ours, const Distances& theirs) {
  const double square = ours.rms.value * ours.rms.value, error = 2 * ours.rms.value * ours.rms.error;
  EXPECT_NEAR(square, theirs.mean_square, 4 * std::hypot(error, theirs.standard_error));
  EXPECT_GE(ours.largest, theirs.largest) << "proved: no point is farther";
  EXPECT_LE(ours.found, ours.largest);
  EXPECT_GE(1.02 * ours.found, theirs.largest) << "a point is so far away, but for the tolerance";
}

void expect_equal(const TestMesh& changed, const TestMesh& original) {
  const auto error =
      surface_error({changed.positions, changed.indices}, {original.positions, original.indices}, {}, 1, Executor(2));
  ASSERT_TRUE(error);
  constexpr int samples = 4000;
  expect_what_cgal_says(error->to_original, by_cgal(changed, original, samples));
  expect_what_cgal_says(error->from_original, by_cgal(original, changed, samples));
}

TEST(SurfaceErrorByCgal, OfACoarserTorusIsTheSame) { expect_equal(testing::torus(20, 12), testing::torus(60, 30)); }

TEST(SurfaceErrorByCgal, OfASphereThatLostAPartAndIsRoughIsTheSame) {
  const TestMesh whole = testing::sphere(40, 20);
  TestMesh rough = testing::sphere(24, 12);
  Random random(5);
  for (glm::vec3& p : rough.positions) p *= 1 + 0.05f * static_cast<float>(random.unit());
  rough.indices.resize(rough.indices.size() * 3 / 4 / 3 * 3);
  expect_equal(rough, whole);
}

}  // namespace
}  // namespace foredraw::surface_error_cgal_test
