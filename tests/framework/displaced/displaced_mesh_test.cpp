#include <foredraw/displaced/displaced_mesh.h>

#include "support/displaced.h"

#include <foredraw/base/random.h>
#include <foredraw/displaced/smooth_directions.h>
#include <foredraw/runtime/displaced_surface.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace foredraw::displaced_mesh_test {
namespace {

using Places = std::vector<std::array<std::int32_t, 2>>;

/// grid(columns, rows) on a map of a texel's size for each unit.
Places places_of(const testing::TestMesh& mesh, std::int32_t texels) {
  Places places;
  for (const glm::vec3& p : mesh.positions)
    places.push_back({static_cast<std::int32_t>(p.x) * texels * 256, static_cast<std::int32_t>(p.y) * texels * 256});
  return places;
}

TEST(DisplacedMesh, LiesOnTheBilinearMapAlongItsDirection) {
  const testing::TestMesh mesh = testing::grid(2, 2);
  HeightMap map{16, 16, {}};
  Random random(3);
  for (int i = 0; i < 256; ++i) map.texels.push_back(static_cast<std::uint16_t>(random.below(65536)));
  const foredraw_height_map ready = sampled(map, {.wrap = {Wrap::clamped, Wrap::clamped}});
  const std::vector<TessellationLevels> levels(8, {{8, 8, 8}, 8});
  const TessellatedMesh fine = tessellated_mesh(mesh.indices, 9, levels, TessellationSpacing::equal);
  const std::vector<float> by = displacements(fine, mesh.indices, places_of(mesh, 8), ready, 2, -1);
  const std::vector<glm::vec3> directions(9, glm::vec3(0, 0, 1));
  const auto moved = displaced_positions(fine, mesh.indices, mesh.positions, directions, by);
  ASSERT_EQ(moved.size(), fine.vertices());
  // By another way: doubles, from the place in the plane.
  const auto height = [&](double x, double y) {
    const auto at = [&](int column, int row) {
      return map.texels[static_cast<std::size_t>(16 * std::clamp(row, 0, 15) + std::clamp(column, 0, 15))] / 65535.0;
    };
    const double u = x * 8 - 0.5, v = y * 8 - 0.5;
    const int column = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
    const double s = u - column, t = v - row;
    return (1 - t) * ((1 - s) * at(column, row) + s * at(column + 1, row)) +
           t * ((1 - s) * at(column, row + 1) + s * at(column + 1, row + 1));
  };
  // Places are rounded to 1/256 texel along both axes, heights to 14 bits.
  for (const glm::vec3& p : moved)
    EXPECT_NEAR(p.z, 2 * height(p.x, p.y) - 1, 2 * (2.0 / 512 + 1.0 / 16384)) << p.x << ' ' << p.y;
}

TEST(DisplacedMesh, OfDirectionsThatCancelStaysInThePlane) {
  const float position[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const float direction[3][3] = {{0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
  const float weight[3] = {0.5f, 0.5f, 0};
  float point[3];
  foredraw_displaced_point(position, direction, weight, 7, point);
  EXPECT_EQ(point[0], 0.5f);
  EXPECT_EQ(point[2], 0);
}

/// A pose that scales moves the surface as much farther as it is larger.
TEST(DisplacedPoint, ScalesWithThePose) {
  const float position[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const float direction[3][3] = {{0, 0.6f, 0.8f}, {0, 0, 1}, {0.6f, 0, 0.8f}};
  const float weight[3] = {0.25f, 0.25f, 0.5f};
  float large[2][3][3], plain[3], scaled[3];
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      large[0][c][axis] = 4 * position[c][axis];
      large[1][c][axis] = 4 * direction[c][axis];
    }
  }
  foredraw_displaced_point(position, direction, weight, 0.5f, plain);
  foredraw_displaced_point(large[0], large[1], weight, 0.5f, scaled);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(scaled[axis], 4 * plain[axis]);
}

TEST(DisplacedPoint, OnAnEdgeHasTheSameBitsFromBothTriangles) {
  Random random(11);
  const auto number = [&] { return static_cast<float>(random.unit() * 2 - 1); };
  for (int i = 0; i < 10'000; ++i) {
    float position[5][3], direction[5][3];
    for (auto* rows : {position, direction}) {
      for (std::size_t v = 0; v < 5; ++v) {
        for (std::size_t axis = 0; axis < 3; ++axis) rows[v][axis] = number();
      }
    }
    const float w = static_cast<float>(random.below(65536)) / 65536, displacement = number();
    const auto at = [&](std::array<std::size_t, 3> corners, std::array<float, 3> weights) {
      float p[3][3], d[3][3];
      for (std::size_t c = 0; c < 3; ++c) {
        std::copy_n(position[corners[c]], 3, p[c]);
        std::copy_n(direction[corners[c]], 3, d[c]);
      }
      std::array<float, 3> point{};
      foredraw_displaced_point(p, d, weights.data(), displacement, point.data());
      return point;
    };
    const auto one = at({0, 1, 2}, {w, 1 - w, 0});
    EXPECT_EQ(one, at({1, 0, 3}, {1 - w, w, 0}));
    EXPECT_EQ(one, at({4, 1, 0}, {0, 1 - w, w}));
    EXPECT_EQ(one, at({0, 2, 1}, {w, 0, 1 - w}));
  }
}

TEST(EdgeLevel, IsTheSameFromBothEndsAndFallsWithTheDistance) {
  const float a[3] = {0, 0, 0}, b[3] = {2, 0, 0}, near[3] = {1, 0, 4}, far[3] = {1, 0, 8};
  EXPECT_EQ(foredraw_edge_level(a, b, near, 800, 20), 20);
  EXPECT_EQ(foredraw_edge_level(b, a, near, 800, 20), 20);
  EXPECT_EQ(foredraw_edge_level(a, b, far, 800, 20), 10);
}

TEST(EdgeLevel, IsOneToSixtyFourWhateverComesIn) {
  const float a[3] = {0, 0, 0}, b[3] = {2, 0, 0}, at[3] = {1, 0, 0}, eye[3] = {1, 0, 1}, broken[3] = {NAN, 0, 0};
  EXPECT_EQ(foredraw_edge_level(a, b, at, 800, 20), 64) << "the eye in its middle";
  EXPECT_EQ(foredraw_edge_level(a, a, a, 800, 20), 1) << "no length";
  EXPECT_EQ(foredraw_edge_level(a, broken, eye, 800, 20), 1);
  EXPECT_EQ(foredraw_edge_level(a, b, eye, 1e-9f, 20), 1);
  EXPECT_EQ(foredraw_edge_level(a, b, eye, 1e30f, 20), 64);
}

TEST(LevelsByTexels, AreTheLargestPowerOfTwoWhosePartsAreLongEnough) {
  const testing::TestMesh mesh = testing::grid(1, 1);
  const auto level = [&](std::int32_t texels, double least) {
    const auto levels = levels_by_texels(mesh.indices, mesh.positions, places_of(mesh, texels), least);
    return *std::min_element(levels[0].outer.begin(), levels[0].outer.end());  // not of the diagonal
  };
  EXPECT_EQ(level(16, 1), 16);
  EXPECT_EQ(level(16, 1.01), 8);
  EXPECT_EQ(level(15, 1), 8);
  EXPECT_EQ(level(1, 2), 1);
  EXPECT_EQ(level(1000, 1), 64);
}

/// A seam: two squares side by side, whose shared edge is long on one map and short on the other.
TEST(LevelsByTexels, AgreeOnBothSidesOfASeam) {
  testing::TestMesh mesh = testing::joined(testing::grid(1, 1), testing::grid(1, 1));
  for (std::size_t v = 4; v < 8; ++v) mesh.positions[v].x += 1;
  Places places = places_of(mesh, 32);
  for (std::size_t v = 4; v < 8; ++v) places[v] = {places[v][0] / 8, places[v][1] / 8};
  const auto levels = levels_by_texels(mesh.indices, mesh.positions, places, 1);
  int seams = 0;
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::vec3 a = mesh.positions[mesh.indices[3 * t + (e + 1) % 3]];
      const glm::vec3 b = mesh.positions[mesh.indices[3 * t + (e + 2) % 3]];
      if (a.x != 1 || b.x != 1) continue;
      EXPECT_EQ(levels[t].outer[e], 4) << "of the shorter side";
      ++seams;
    }
    EXPECT_EQ(levels[t].inner, *std::max_element(levels[t].outer.begin(), levels[t].outer.end()));
  }
  EXPECT_EQ(seams, 2);
}

/// The same position, the same direction, the same height: the same point, though the vertices differ.
TEST(DisplacedMesh, HasNoCrackAlongAnEdgeWhoseVerticesDiffer) {
  testing::TestMesh mesh = testing::joined(testing::grid(1, 1), testing::grid(1, 1));
  for (std::size_t v = 4; v < 8; ++v) {
    mesh.positions[v].x += 1;
    mesh.positions[v].z = mesh.positions[v].x > 1.5f ? 0.7f : 0.0f;
  }
  HeightMap map{64, 64, {}};
  Random random(5);
  for (int i = 0; i < 4096; ++i) map.texels.push_back(static_cast<std::uint16_t>(random.below(65536)));
  const foredraw_height_map ready = sampled(map, {});
  const Places places = places_of(mesh, 32);
  const auto levels = levels_by_texels(mesh.indices, mesh.positions, places, 2);
  const TessellatedMesh fine = tessellated_mesh(mesh.indices, 8, levels, TessellationSpacing::equal);
  const std::vector<float> by = displacements(fine, mesh.indices, places, ready, 0.3f, 0.1f);
  const DirectedPart parts[] = {{mesh.positions, {}, mesh.indices}};
  const auto directions = smooth_directions(parts)[0];
  const auto flat =
      displaced_positions(fine, mesh.indices, mesh.positions, directions, std::vector<float>(fine.vertices(), 0.0f));
  const auto moved = displaced_positions(fine, mesh.indices, mesh.positions, directions, by);
  std::map<float, std::vector<std::size_t>> seam;
  for (std::size_t v = 0; v < flat.size(); ++v) {
    if (flat[v].x == 1) seam[flat[v].y].push_back(v);
  }
  EXPECT_EQ(seam.size(), 17u);
  for (const auto& [y, vertices] : seam) {
    ASSERT_EQ(vertices.size(), 2u) << y;
    EXPECT_EQ(moved[vertices[0]], moved[vertices[1]]) << y;
  }
}

}  // namespace
}  // namespace foredraw::displaced_mesh_test
