// Our triangles that pass through each other against CGAL's. Where CGAL is not found this is not built.

#include <foredraw/analysis/crossing_triangles.h>

#include "support/meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace foredraw::crossing_triangles_cgal_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// All pairs, by exact predicates; none of two triangles with a common corner.
std::vector<std::uint8_t> by_cgal(const testing::TestMesh& mesh) {
  const std::size_t count = mesh.indices.size() / 3;
  std::vector<std::array<glm::vec3, 3>> corners(count);
  std::vector<Kernel::Triangle_3> triangles;
  for (std::size_t t = 0; t < count; ++t) {
    std::array<Kernel::Point_3, 3> at;
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::vec3 p = corners[t][c] = mesh.positions[mesh.indices[3 * t + c]];
      at[c] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    }
    triangles.emplace_back(at[0], at[1], at[2]);
  }
  std::vector<std::uint8_t> crosses(count, 0);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      bool is_joined = false;
      for (const glm::vec3& p : corners[a]) {
        for (const glm::vec3& q : corners[b]) is_joined = is_joined || p == q;
      }
      if (is_joined || triangles[a].is_degenerate() || triangles[b].is_degenerate()) continue;
      if (CGAL::do_intersect(triangles[a], triangles[b])) crosses[a] = crosses[b] = 1;
    }
  }
  return crosses;
}

void expect_equal(const testing::TestMesh& mesh) {
  EXPECT_EQ(crossing_triangles({mesh.positions, mesh.indices}, Executor(2)), by_cgal(mesh));
}

TEST(CrossingTrianglesByCgal, OfRandomTrianglesAreTheSame) {
  for (const std::uint64_t seed : {1, 2, 3}) expect_equal(testing::soup(300, seed));
}

TEST(CrossingTrianglesByCgal, OfATorusThatIsSquashedAreTheSame) {
  testing::TestMesh torus = testing::torus(40, 24);
  expect_equal(torus);
  Random random(4);
  for (glm::vec3& p : torus.positions) p += 0.2f * glm::vec3(random.unit(), random.unit(), random.unit());
  expect_equal(torus);
}

}  // namespace
}  // namespace foredraw::crossing_triangles_cgal_test
