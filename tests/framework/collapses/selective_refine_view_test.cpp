#include <foredraw/runtime/selective_refine.h>

#include "support/refined.h"

namespace foredraw::selective_refine_view_test {
namespace {

using testing::Refined;
using testing::TestMesh;

/// A ball seen from the right.
class RefineView : public ::testing::Test {
 protected:
  RefineView() {
    view_.eye[0] = 4;
    view_.pixels = 1000;
    for (auto& split : one_.records.progressive.splits) split.error = 1e-4f * (split.triangles < 400 ? 40.0f : 1.0f);
  }

  void look() {
    one_.settle([&](std::uint32_t split) { return foredraw_refine_view_wants(&view_, &one_.arrays, split) != 0; });
  }
  /// Triangles whose middle is in a slice of the ball across the line of sight.
  int in_slice(float from, float to) const {
    const TestMesh left = one_.surface();
    int count = 0;
    for (std::size_t i = 0; i < left.indices.size(); i += 3) {
      const float x = (left.positions[left.indices[i]].x + left.positions[left.indices[i + 1]].x +
                       left.positions[left.indices[i + 2]].x) /
                      3;
      count += x >= from && x < to;
    }
    return count;
  }

  Refined one_{testing::sphere(64, 48)};
  foredraw_refine_view view_{};
};

TEST_F(RefineView, BackSidesStayCoarse) {
  view_.surface = view_.silhouette = 1e-6f;
  look();
  const int front = in_slice(0.3f, 1), back = in_slice(-1, -0.4f);
  EXPECT_GT(front, 10 * back);
  view_.back_sides = 1;
  look();
  EXPECT_EQ(one_.state.done, one_.splits());
}

TEST_F(RefineView, OutlinesAreFiner) {
  view_.surface = 1.0f;
  view_.silhouette = 0.005f;
  look();
  const int outline = in_slice(0.1f, 0.4f), middle = in_slice(0.7f, 1);
  EXPECT_GT(outline, 2 * middle) << middle;
  view_.silhouette = view_.surface;
  look();
  EXPECT_LT(in_slice(0.1f, 0.4f), outline);
}

TEST_F(RefineView, WhatIsOutsideOfTheFrustumStaysCoarse) {
  view_.surface = view_.silhouette = 1e-6f;
  view_.back_sides = 1;
  view_.planes[2][0] = 1;  // x >= 0.5
  view_.planes[2][3] = -0.5f;
  look();
  EXPECT_GT(in_slice(0.5f, 1), 8 * in_slice(-1, -0.5f));
  EXPECT_LT(one_.state.done, one_.splits());
}

TEST_F(RefineView, TheNearestPlaceOfABallCounts) {
  view_.back_sides = 1;
  view_.eye[0] = 60;
  for (std::uint32_t s = 0; s < one_.splits(); s += 50) {
    const foredraw_refine_node& node = one_.records.nodes[s];
    const float away = std::hypot(node.centre[0] - 60, node.centre[1], node.centre[2]) - node.radius;
    const float pixels = one_.records.progressive.splits[s].error * view_.pixels / away;
    view_.surface = view_.silhouette = 1.001f * pixels;
    EXPECT_EQ(foredraw_refine_view_wants(&view_, &one_.arrays, s), 0) << s;
    view_.surface = view_.silhouette = 0.999f * pixels;
    EXPECT_EQ(foredraw_refine_view_wants(&view_, &one_.arrays, s), 1) << s;
  }
  const foredraw_refine_node& node = one_.records.nodes[0];
  std::copy_n(node.centre, 3, view_.eye);  // within a ball everything that is off is seen
  view_.surface = view_.silhouette = 1e9f;
  EXPECT_EQ(foredraw_refine_view_wants(&view_, &one_.arrays, 0), 1);
}

TEST_F(RefineView, FartherAwayIsCoarser) {
  view_.surface = view_.silhouette = 0.05f;
  view_.back_sides = 1;
  std::uint32_t before = ~0u;
  for (const float away : {2.0f, 8.0f, 60.0f, 200.0f}) {
    view_.eye[0] = away;
    look();
    EXPECT_LE(one_.state.triangles, before);
    before = one_.state.triangles;
  }
  EXPECT_EQ(one_.state.done, 0u);
}

}  // namespace
}  // namespace foredraw::selective_refine_view_test
