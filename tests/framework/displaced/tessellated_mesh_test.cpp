#include <foredraw/analysis/welded_positions.h>
#include <foredraw/base/random.h>
#include <foredraw/displaced/tessellated_mesh.h>

#include "support/collapses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace foredraw::tessellated_mesh_test {
namespace {

using enum TessellationSpacing;
using testing::TestMesh;

constexpr TessellationSpacing spacings[] = {equal, fractional_odd, fractional_even};

float random_level(Random& random, double most) { return static_cast<float>(0.5 + most * random.unit()); }

/// Random, and the same for all triangles at an edge.
std::vector<TessellationLevels> levels_of(const TestMesh& mesh, std::uint64_t seed, double most) {
  std::vector<TessellationLevels> levels(mesh.indices.size() / 3);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t t = i / 3;
    const std::uint32_t a = mesh.indices[3 * t + (i + 1) % 3], b = mesh.indices[3 * t + (i + 2) % 3];
    Random edge(derive_seed(seed, std::min(a, b), std::max(a, b))), inner(derive_seed(~seed, t, 0));
    levels[t].outer[i % 3] = random_level(edge, most);
    levels[t].inner = random_level(inner, most);
  }
  return levels;
}

TessellatedMesh tessellated(const TestMesh& mesh, const std::vector<TessellationLevels>& levels,
                            TessellationSpacing spacing) {
  return tessellated_mesh(mesh.indices, static_cast<std::uint32_t>(mesh.positions.size()), levels, spacing);
}

/// Where it lies, without a word of who asks: vertices of the source by their weights.
using Place = std::map<std::uint32_t, std::uint32_t>;

Place place_of(const TestMesh& mesh, std::size_t triangle, const TessellationPoint& at) {
  Place place;
  for (std::size_t c = 0; c < 3; ++c) {
    if (at.weights()[c] > 0) place[mesh.indices[3 * triangle + c]] += at.weights()[c];
  }
  return place;
}

std::vector<Place> places(const TestMesh& mesh, const TessellatedMesh& made) {
  std::vector<Place> places;
  for (std::uint32_t v = 0; v < made.kept; ++v) places.push_back({{v, weight_one}});
  for (const SurfaceSample& sample : made.samples) places.push_back(place_of(mesh, sample.triangle, sample.at));
  return places;
}

std::vector<TestMesh> closed_meshes() {
  TestMesh sphere = testing::closed_torus(7, 5);
  return {testing::closed_torus(9, 6),
          testing::shuffled(sphere, 3),
          {std::vector<glm::vec3>(4), {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}}};
}

TEST(TessellatedMesh, levels_of_one_change_nothing) {
  for (const TestMesh& mesh : {testing::sphere(9, 5), testing::soup(50, 1), testing::spokes(40), TestMesh{}}) {
    const std::vector<TessellationLevels> ones(mesh.indices.size() / 3);
    for (const TessellationSpacing spacing : {equal, fractional_odd}) {
      const TessellatedMesh made = tessellated(mesh, ones, spacing);
      EXPECT_EQ(made.indices, mesh.indices);
      EXPECT_TRUE(made.samples.empty());
      EXPECT_EQ(made.vertices(), mesh.positions.size());
    }
  }
}

TEST(TessellatedMesh, each_triangle_becomes_its_pattern) {
  std::uint64_t seed = 0;
  for (const TestMesh& mesh : closed_meshes()) {
    for (const TessellationSpacing spacing : spacings) {
      const auto levels = levels_of(mesh, ++seed, 12);
      const TessellatedMesh made = tessellated(mesh, levels, spacing);
      const std::vector<Place> lies = places(mesh, made);
      std::size_t i = 0;
      for (std::size_t t = 0; t < levels.size(); ++t) {
        const TessellationPattern pattern = tessellation_pattern(levels[t], spacing);
        for (const auto& triangle : pattern.triangles) {
          for (const std::uint16_t point : triangle) {
            ASSERT_LT(i, made.indices.size());
            EXPECT_EQ(lies.at(made.indices[i++]), place_of(mesh, t, pattern.points[point]));
          }
        }
      }
      EXPECT_EQ(i, made.indices.size());
    }
  }
}

TEST(TessellatedMesh, what_is_closed_stays_closed) {
  std::uint64_t seed = 10;
  for (const TestMesh& mesh : closed_meshes()) {
    for (const TessellationSpacing spacing : spacings) {
      const TessellatedMesh made = tessellated(mesh, levels_of(mesh, ++seed, 20), spacing);
      std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
      for (std::size_t i = 0; i < made.indices.size(); ++i) {
        const std::uint32_t from = made.indices[i], to = made.indices[i - i % 3 + (i + 1) % 3];
        EXPECT_TRUE(sides.emplace(from, to).second);
      }
      for (const auto& [from, to] : sides) EXPECT_TRUE(sides.contains({to, from}));
      // And has no new hole or handle.
      const auto euler = [](const TestMesh& of) {
        const std::set<std::uint32_t> used(of.indices.begin(), of.indices.end());
        return static_cast<long>(used.size()) - static_cast<long>(of.indices.size() / 6);
      };
      EXPECT_EQ(euler({{}, made.indices}), euler(mesh));
    }
  }
}

TEST(TessellatedMesh, every_vertex_is_new_and_in_use) {
  const TestMesh mesh = closed_meshes()[1];
  const TessellatedMesh made = tessellated(mesh, levels_of(mesh, 20, 9), equal);
  const std::set<std::uint32_t> used(made.indices.begin(), made.indices.end());
  for (std::size_t v = made.kept; v < made.vertices(); ++v) EXPECT_TRUE(used.contains(static_cast<std::uint32_t>(v)));
  std::vector<Place> lies = places(mesh, made);
  std::sort(lies.begin(), lies.end());
  EXPECT_EQ(std::adjacent_find(lies.begin(), lies.end()), lies.end());
  for (std::size_t i = 1; i < made.samples.size(); ++i) {
    EXPECT_LE(made.samples[i - 1].triangle, made.samples[i].triangle);
  }
}

TEST(TessellatedMesh, three_triangles_share_the_points_of_one_edge) {
  const TestMesh fins{std::vector<glm::vec3>(5), {0, 1, 2, 1, 0, 3, 0, 1, 4}};
  std::vector<TessellationLevels> levels(3);
  for (TessellationLevels& three : levels) three.outer[2] = 5;
  const TessellatedMesh made = tessellated(fins, levels, equal);
  // 4 points on the edge, and one inside each.
  EXPECT_EQ(made.samples.size(), 4u + 3);
  EXPECT_EQ(made.indices.size() / 3, 3 * tessellation_counts(levels[0], equal).triangles);
}

TEST(TessellatedMesh, levels_that_do_not_agree_are_named) {
  const TestMesh pair{std::vector<glm::vec3>(4), {0, 1, 2, 2, 1, 3}};
  std::vector<TessellationLevels> levels(2);
  levels[0].outer[0] = 2.25f;
  levels[1].outer[2] = 2.75f;
  EXPECT_FALSE(level_disagreement(pair.indices, 4, levels, equal));  // both are 3
  EXPECT_NO_THROW(tessellated(pair, levels, equal));
  const auto found = level_disagreement(pair.indices, 4, levels, fractional_odd);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edge, 5u);
  EXPECT_EQ(found->other, 0u);
  try {
    tessellated(pair, levels, fractional_odd);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "edge 2 of triangle 1 has level 2.750000, but edge 0 of triangle 0 has level 2.250000, and they are "
                 "the same edge: compute levels from its two vertices alone");
  }
}

TEST(TessellatedMesh, seams_agree_where_levels_come_from_positions) {
  const TestMesh box = testing::box_of_sides(3);
  const std::vector<std::uint32_t> first = welded(box.positions);
  TestMesh closed = box;
  for (std::uint32_t& v : closed.indices) v = first[v];
  const auto vertices = static_cast<std::uint32_t>(box.positions.size());
  const auto by_number = levels_of(box, 1, 9), by_position = levels_of(closed, 1, 9);
  EXPECT_FALSE(level_disagreement(box.indices, vertices, by_number, equal));
  EXPECT_TRUE(level_disagreement(closed.indices, vertices, by_number, equal));
  EXPECT_FALSE(level_disagreement(closed.indices, vertices, by_position, equal));
  // Then both sides of a seam have their points in the same places.
  const TessellatedMesh made = tessellated(box, by_position, equal);
  std::vector<Place> lies = places(closed, made);
  for (std::uint32_t v = 0; v < made.kept; ++v) lies[v] = {{first[v], weight_one}};
  std::map<std::pair<Place, Place>, int> sides;
  for (std::size_t i = 0; i < made.indices.size(); ++i) {
    const Place &from = lies[made.indices[i]], &to = lies[made.indices[i - i % 3 + (i + 1) % 3]];
    ++sides[{from, to}];
    --sides[{to, from}];
  }
  for (const auto& [ends, surplus] : sides) EXPECT_EQ(surplus, 0);
}

TEST(TessellatedMesh, triangles_with_a_level_of_zero_are_left_out) {
  const TestMesh strip{std::vector<glm::vec3>(5), {0, 1, 2, 2, 1, 3, 2, 3, 4}};
  std::vector<TessellationLevels> levels(3, {{3, 3, 3}, 3});
  for (const float none : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    levels[0].outer[1] = none;
    const TessellatedMesh made = tessellated(strip, levels, equal);
    EXPECT_EQ(made.indices.size() / 3, 26u);
    EXPECT_EQ(made.samples.size(), 5u * 2 + 2 * 3 - 0);  // of 5 edges, 2 inner triangles
    for (const SurfaceSample& sample : made.samples) EXPECT_GT(sample.triangle, 0u);
  }
}

TEST(TessellatedMesh, odd_meshes_are_tessellated_too) {
  std::uint64_t seed = 30;
  for (const TestMesh& mesh : testing::odd_meshes()) {
    const auto levels = levels_of(mesh, ++seed, 3);
    std::size_t triangles = 0;
    for (const TessellationLevels& three : levels) triangles += tessellation_counts(three, equal).triangles;
    const TessellatedMesh made = tessellated(mesh, levels, equal);
    EXPECT_EQ(made.indices.size() / 3, triangles);
    for (const std::uint32_t v : made.indices) EXPECT_LT(v, made.vertices());
  }
}

TEST(TessellatedMesh, refuses_what_is_no_mesh_or_too_much) {
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  const std::vector<TessellationLevels> one(1), two(2);
  EXPECT_THROW(tessellated_mesh(indices, 3, two, equal), std::invalid_argument);
  EXPECT_THROW(tessellated_mesh(indices, 2, one, equal), std::invalid_argument);
  EXPECT_THROW(level_disagreement(indices, 2, one, equal), std::invalid_argument);
  // 1.4 million triangles that share no edge, of more than 3,000 points each.
  constexpr std::uint32_t triangles = 1'400'000;
  std::vector<std::uint32_t> many(3 * triangles);
  for (std::uint32_t i = 0; i < many.size(); ++i) many[i] = i;
  const std::vector<TessellationLevels> most(triangles, {{64, 64, 64}, 64});
  EXPECT_THROW(tessellated_mesh(many, 3 * triangles, most, equal), std::length_error);
}

}  // namespace
}  // namespace foredraw::tessellated_mesh_test
