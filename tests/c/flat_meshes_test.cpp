// Meshes that are shaded flat have the sequences of the function for C++.

#include <foredraw/c/functions.h>
#include <foredraw/collapses/alike_vertices.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include "bumpy_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::flat_meshes_test {
namespace {

using testing::BumpySheet;

class FlatMeshesForC : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Places, FlatMeshesForC, ::testing::Bool());

/// Vertices that differ in a direction alone may stand for each other.
TEST_P(FlatMeshesForC, CollapseAsByTheFunction) {
  const BumpySheet sheet(20, BumpySheet::own_corners);
  const std::vector<glm::vec3> places = sheet.places();
  const std::vector<std::uint32_t> indices(sheet.indices.begin(), sheet.indices.end());
  constexpr float weight = 0.5f;
  std::vector<float> normals;
  AttributeRows rows{.width = 3, .values = {}, .directions = {{0, weight}}};
  for (std::size_t v = 0; v < places.size(); ++v) {
    const glm::vec3 &a = places[v - v % 3], b = places[v - v % 3 + 1] - a, c = places[v - v % 3 + 2] - a;
    const glm::vec3 up{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
    const float length = std::sqrt(up.x * up.x + up.y * up.y + up.z * up.z);
    for (int k = 0; k < 3; ++k) {
      normals.push_back(up[k] / length);
      rows.values.push_back(normals.back() * weight);
    }
  }
  rows.alike = alike_vertices(rows, places);
  const foredraw_weighted_attribute attribute{normals.data(), 0, 3 + FOREDRAW_DIRECTION, weight};
  const foredraw_triangles triangles = sheet.triangles();
  const foredraw_positions positions = sheet.positions();
  std::vector<foredraw_collapse> collapses(places.size());
  std::vector<foredraw_vertex_pair> pairs(places.size());
  std::vector<std::uint32_t> first_pair(places.size() + 1);
  std::vector<float> places_then(3 * places.size());
  foredraw_collapses sequence{
      collapses.data(), pairs.data(), first_pair.data(), GetParam() ? places_then.data() : nullptr, 0, 1};
  ASSERT_EQ(foredraw_quadric_collapse(&sequence, &triangles, &positions, &attribute, 1, 0), FOREDRAW_DONE);
  const CollapseSequence made = quadric_collapse(
      places, indices, {.placement = GetParam() ? CollapsePlacement::optimal : CollapsePlacement::endpoint}, rows);
  EXPECT_GT(made.collapses.size(), 300u);
  ASSERT_EQ(sequence.count, made.collapses.size());
  for (std::size_t i = 0; i < made.pairs.size(); ++i) {
    ASSERT_EQ(pairs[i].removed, made.pairs[i].removed);
    ASSERT_EQ(pairs[i].kept, made.pairs[i].kept);
  }
  if (!GetParam()) return;  // points stay where they are
  EXPECT_TRUE(std::equal(made.places.begin(), made.places.end(), places_then.begin()));
}

}  // namespace
}  // namespace foredraw::flat_meshes_test
