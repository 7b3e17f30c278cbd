#include <foredraw/analysis/mesh_facts.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace foredraw::mesh_facts_test {
namespace {

using testing::TestMesh;

MeshFacts facts_of(const TestMesh& mesh) { return mesh_facts(mesh.positions, mesh.indices); }

TEST(MeshFacts, a_clean_mesh_has_nothing_unusual) {
  EXPECT_EQ(facts_of(testing::grid(4, 3)), (MeshFacts{.triangles = 24, .vertices = 20}));
  EXPECT_EQ(mesh_facts({}, {}), MeshFacts{});
}

TEST(MeshFacts, each_oddity_is_counted_once) {
  TestMesh mesh = testing::grid(1, 1);                                         // 0 1 2, 2 1 3
  mesh.positions.emplace_back(2, 0, 0);                                        // 4, on the line of 0 and 1
  mesh.positions.emplace_back(std::numeric_limits<float>::infinity(), 0, 0);   // 5
  mesh.positions.emplace_back(0, 0, std::numeric_limits<float>::quiet_NaN());  // 6, never referenced
  const std::vector<std::uint32_t> more = {1, 2, 0,                            // the first triangle, rotated
                                           0, 2, 1,                            // turned over: no duplicate
                                           0, 0, 3,                            // repeated corner
                                           0, 1, 4,   // zero area, and the fourth triangle on the edge 0 1
                                           3, 4, 5};  // no area can be told
  mesh.indices.insert(mesh.indices.end(), more.begin(), more.end());
  EXPECT_EQ(facts_of(mesh), (MeshFacts{.triangles = 7,
                                       .vertices = 7,
                                       .unreferenced_vertices = 1,
                                       .non_finite_positions = 2,
                                       .repeated_corners = 1,
                                       .zero_area = 1,
                                       .duplicate_triangles = 1,
                                       .non_manifold_edges = 3}));
}

TEST(MeshFacts, collinear_is_exact) {
  // In floats, and even in doubles, the area of these rounds to 0 or away from it.
  EXPECT_TRUE(are_collinear({0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 0.2f}, {1e30f, 1e30f, 1e30f}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1e30f, 1e30f, 0}, {1e-30f, 2e-30f, 0}));
  EXPECT_FALSE(are_collinear({1e30f, 0, 0}, {0, 1e-40f, 0}, {0, 0, 0}));
  const float next = std::nextafter(1.0f, 2.0f);
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 1, 1}, {next, 1, 1}));
  EXPECT_TRUE(are_collinear({1, 2, 3}, {1, 2, 3}, {5, 5, 5}));
}

RC_GTEST_PROP(MeshFacts, whole_numbers_agree_with_integer_arithmetic, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(-4, 5); };
  std::array<std::array<long, 3>, 3> p;
  for (auto& corner : p) corner = {coordinate(), coordinate(), coordinate()};
  bool flat = true;
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    flat = flat && (p[1][x] - p[0][x]) * (p[2][y] - p[0][y]) == (p[1][y] - p[0][y]) * (p[2][x] - p[0][x]);
  }
  const auto at = [&](int i) { return glm::vec3(p[i][0], p[i][1], p[i][2]) * 0x1p-100f; };
  RC_ASSERT(are_collinear(at(0), at(1), at(2)) == flat);
}

}  // namespace
}  // namespace foredraw::mesh_facts_test
