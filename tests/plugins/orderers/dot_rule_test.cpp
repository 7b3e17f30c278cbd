#include "plugins/orderers/dot_rule/dot_rule.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::dot_rule_test {
namespace {

using testing::TestMesh;

/// Two spheres in one another, the small one first: each one cluster of outward triangles.
TEST(DotRule, DrawsWhatFacesOutwardsFirst) {
  // A dome that faces up above the centre, and one that faces down into the mesh.
  TestMesh up = testing::grid(4, 4);
  TestMesh down = testing::grid(4, 4);
  for (auto& p : up.positions) p.z = 2;
  for (auto& p : down.positions) p.z = 1;
  for (std::size_t t = 0; t < down.indices.size(); t += 3) std::swap(down.indices[t], down.indices[t + 1]);
  TestMesh floor = testing::grid(4, 4);  // faces up at the bottom: into the mesh
  const TestMesh mesh = testing::joined(testing::joined(floor, down), up);

  const auto each = static_cast<std::uint32_t>(up.indices.size() / 3);
  const Clusters clusters{{0, each, 2 * each, 3 * each}};
  EXPECT_EQ(dot_rule(mesh.positions, mesh.indices, clusters), (std::vector<std::uint32_t>{2, 1, 0}));
}

TEST(DotRule, FollowsTheFormula) {
  // One triangle a cluster at heights 3, 0, 5 with normals +z: the key is height - mean.
  TestMesh mesh;
  for (float z : {3.0f, 0.0f, 5.0f}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 0, z}, {1, 0, z}, {0, 1, z}});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  EXPECT_EQ(dot_rule(mesh.positions, mesh.indices, {{0, 1, 2, 3}}), (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(DotRule, KeepsTheSequenceOfEqualsAndPutsClustersWithoutAreaLast) {
  TestMesh mesh;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (glm::vec3 apex : {glm::vec3(nan), glm::vec3(0, 1, 0), glm::vec3(2, 0, 0), glm::vec3(0, 1, 0)}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {1, 0, 0}, apex});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  EXPECT_EQ(dot_rule(mesh.positions, mesh.indices, {{0, 1, 2, 3, 4}}), (std::vector<std::uint32_t>{1, 3, 0, 2}));
}

TEST(DotRule, ReadsAnInterleavedBuffer) {
  struct Vertex {
    std::uint16_t colour[3];
    float position[3];
    float u, v;
  };
  const TestMesh mesh = testing::torus(40, 20);
  std::vector<Vertex> vertices;
  for (const glm::vec3& p : mesh.positions) vertices.push_back({{}, {p.x, p.y, p.z}, 0, 0});
  Clusters clusters{{0}};
  while (clusters.offsets.back() < mesh.indices.size() / 3) clusters.offsets.push_back(clusters.offsets.back() + 40);
  EXPECT_EQ(dot_rule({vertices[0].position, vertices.size(), sizeof(Vertex)}, mesh.indices, clusters),
            dot_rule(mesh.positions, mesh.indices, clusters));
}

TEST(DotRule, OfNothingIsNothing) { EXPECT_TRUE(dot_rule({}, {}, {{0}}).empty()); }

}  // namespace
}  // namespace foredraw::dot_rule_test
