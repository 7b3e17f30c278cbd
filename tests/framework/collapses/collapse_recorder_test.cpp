#include "support/collapses.h"

#include <foredraw/collapses/collapse_recorder.h>

#include <gtest/gtest.h>

namespace foredraw::collapse_recorder_test {
namespace {

using testing::TestMesh;

/// Collapses what may be, edge after edge, until nothing may.
CollapseSequence all_of(const TestMesh& mesh) {
  CollapseRecorder recorder(mesh.positions, mesh.indices);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t t = 0; t < recorder.points().size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t p = recorder.points()[t][k], q = recorder.points()[t][(k + 1) % 3];
        if (p == q || recorder.triangles_of_edge(p, q) == 0) continue;
        if (!recorder.keeps_topology(p, q) || !recorder.pairs_up(p, q)) continue;
        recorder.collapse(p, q, {.error = static_cast<double>(t % 7)});
        has_changed = true;
      }
    }
  }
  return recorder.take();
}

TEST(CollapseRecorder, WhatItLetsThroughRunsCleanly) {
  for (const TestMesh& mesh : testing::odd_meshes()) {
    EXPECT_EQ(replay(all_of(mesh), mesh.positions, mesh.indices).mistake, "");
  }
}

TEST(CollapseRecorder, TopologyStays) {
  const TestMesh torus = testing::closed_torus(16, 8), ring = testing::flat_ring(24, 4);
  EXPECT_EQ(testing::euler(testing::coarse(torus, all_of(torus), 0)), 0);
  EXPECT_EQ(testing::euler(testing::coarse(ring, all_of(ring), 0)), 0);
  const TestMesh strip = testing::moebius_strip(40);
  EXPECT_EQ(testing::euler(testing::coarse(strip, all_of(strip), 0)), 0);
  const TestMesh box = testing::box_of_sides(4);
  const TestMesh left = testing::coarse(box, all_of(box), 0);
  EXPECT_EQ(testing::euler(left), 2);
  EXPECT_EQ(testing::edges(left).size(), 1u);
}

TEST(CollapseRecorder, CountsWhatIsLeft) {
  const TestMesh plate = testing::grid(4, 4);
  CollapseRecorder recorder(plate.positions, plate.indices);
  EXPECT_EQ(recorder.triangle_count(), 32u);
  ASSERT_TRUE(recorder.keeps_topology(6, 7) && recorder.pairs_up(6, 7));
  recorder.collapse(6, 7, {});
  EXPECT_EQ(recorder.triangle_count(), 30u);
  EXPECT_TRUE(recorder.triangles_at(6).empty());
  EXPECT_FALSE(recorder.keeps_topology(0, 24));  // no edge
}

TEST(CollapseRecorder, BlendsRunFromTheKeptPointToTheRemovedOne) {
  EXPECT_EQ(blend_of({0, 0, 0}, {2, 0, 0}, {0.5f, 1, 0}), 0.25f);
  EXPECT_EQ(blend_of({0, 0, 0}, {2, 0, 0}, {-1, 0, 0}), 0.0f);
  EXPECT_EQ(blend_of({0, 0, 0}, {2, 0, 0}, {3, 0, 0}), 1.0f);
  EXPECT_EQ(blend_of({1, 1, 1}, {1, 1, 1}, {3, 0, 0}), 0.0f);
}

}  // namespace
}  // namespace foredraw::collapse_recorder_test
