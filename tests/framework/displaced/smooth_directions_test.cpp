#include <foredraw/displaced/smooth_directions.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <limits>

namespace foredraw::smooth_directions_test {
namespace {

/// A cube whose every face has four vertices of its own, with the face's normal.
struct Cube {
  std::vector<glm::vec3> positions, normals;
  std::vector<std::uint32_t> indices;

  Cube() {
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0f, 1.0f}) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (const auto& [u, v] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
          glm::vec3 p, n(0);
          p[axis] = n[axis] = side;
          p[(axis + 1) % 3] = u * side;
          p[(axis + 2) % 3] = v;
          positions.push_back(p);
          normals.push_back(n);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + corner);
      }
    }
  }

  DirectedPart part() const { return {positions, normals, indices}; }
};

void expect_near(const glm::vec3& a, const glm::vec3& b) { EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << ' ' << b.x; }

TEST(SmoothDirections, AreOneForEachPositionWhateverVerticesLieThere) {
  const Cube cube;
  const DirectedPart parts[] = {cube.part()};
  const auto directions = smooth_directions(parts)[0];
  for (std::size_t v = 0; v < directions.size(); ++v) {
    // Each face counts alike at a corner, though it is cut there into one triangle or two.
    expect_near(directions[v], glm::normalize(cube.positions[v]));
    for (std::size_t other = 0; other < v; ++other) {
      EXPECT_EQ(cube.positions[v] == cube.positions[other], directions[v] == directions[other]);
    }
  }
}

TEST(SmoothDirections, OfFacesCountWhereThereAreNoNormals) {
  const Cube cube;
  const DirectedPart parts[] = {{cube.positions, {}, cube.indices}};
  const auto directions = smooth_directions(parts)[0];
  for (std::size_t v = 0; v < directions.size(); ++v) expect_near(directions[v], glm::normalize(cube.positions[v]));
}

TEST(SmoothDirections, JoinAcrossParts) {
  const Cube cube;
  const std::span<const std::uint32_t> all = cube.indices;
  const DirectedPart parts[] = {{cube.positions, cube.normals, all.first(18)},
                                {cube.positions, cube.normals, all.last(18)}};
  const DirectedPart whole[] = {cube.part()};
  const auto of_parts = smooth_directions(parts);
  EXPECT_EQ(of_parts[0], of_parts[1]);
  for (std::size_t v = 0; v < of_parts[0].size(); ++v) expect_near(of_parts[0][v], smooth_directions(whole)[0][v]);
}

TEST(SmoothDirections, FollowStoredNormalsAndNotFaces) {
  const testing::TestMesh mesh = testing::grid(2, 2);
  const std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0, 3, 4));
  const DirectedPart parts[] = {{mesh.positions, normals, mesh.indices}};
  const auto directions = smooth_directions(parts);
  for (const glm::vec3& direction : directions[0]) expect_near(direction, glm::vec3(0, 0.6f, 0.8f));
}

TEST(SmoothDirections, OfBadNormalsAreTheFacesAndOfBadFacesNone) {
  testing::TestMesh mesh = testing::grid(1, 1);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::vec3> normals(4, glm::vec3(0));
  normals[0] = {nan, 0, 0};
  const DirectedPart parts[] = {{mesh.positions, normals, mesh.indices}};
  const auto directions = smooth_directions(parts);
  for (const glm::vec3& direction : directions[0]) expect_near(direction, glm::vec3(0, 0, 1));
  mesh.positions[3] = glm::vec3(nan);
  const DirectedPart broken[] = {{mesh.positions, normals, mesh.indices}};
  EXPECT_EQ(smooth_directions(broken)[0][3], glm::vec3(0));
  const std::vector<glm::vec3> one_place(4, glm::vec3(1));
  const DirectedPart empty[] = {{one_place, {}, mesh.indices}};
  EXPECT_EQ(smooth_directions(empty)[0], std::vector<glm::vec3>(4, glm::vec3(0)));
}

TEST(SmoothDirections, OfATinySurfaceAreAsThoseOfALargeOne) {
  for (const float scale : {1e-20f, 1e15f}) {
    Cube cube;
    for (glm::vec3& p : cube.positions) p *= scale;
    const DirectedPart parts[] = {cube.part()};
    const auto directions = smooth_directions(parts)[0];
    for (std::size_t v = 0; v < directions.size(); ++v) expect_near(directions[v], glm::normalize(Cube().positions[v]));
  }
}

}  // namespace
}  // namespace foredraw::smooth_directions_test
